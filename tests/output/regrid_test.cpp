#include "solver/output/regrid.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/output/agree.hpp"
#include "solver/time/initial.hpp"
#include "tests/output/sample_state.hpp"
#include "tests/output/shared_folder.hpp"
#include "tests/support/order.hpp"

namespace softwall::output {
namespace {

using support::kCaseId;

class RegridTest : public testing::Test {
 protected:
  parallel::Communicator world_ = parallel::Communicator::duplicate(MPI_COMM_WORLD);
  support::SharedFolder folder_{world_};
  RunFiles run_{folder_.path()};

  std::filesystem::path write(time::State& state, time::Setup& setup) {
    return write_checkpoint(run_, {kCaseId, 0}, state, {}, setup);
  }
  static InitialSpec initial() { return {.type = InitialType::kPrecursor, .precursor = kCaseId}; }
};

TEST(Weights, AreExactWhereGridsCoincide) {
  for (const double offset : {0.0, 0.5}) {
    const auto weights = periodic_weights(7, 7, offset);
    for (int i = 0; i < 7; ++i) {
      EXPECT_EQ(weights[static_cast<std::size_t>(i)].low, i);
      EXPECT_EQ(weights[static_cast<std::size_t>(i)].share, 0.0);
    }
  }
  const std::vector<double> nodes{0.0, 0.1, 0.37, 1.9, 2.0};
  const auto weights = height_weights(nodes, nodes);
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    EXPECT_EQ(weights[j].low, static_cast<int>(j));
    EXPECT_EQ(weights[j].share, 0.0);
  }
}

TEST(Weights, WrapAroundThePeriodAndStopAtTheEnds) {
  const auto finer = periodic_weights(4, 8, 0.5);  // the first point lies before the first source point
  EXPECT_EQ(finer.front().low, 3);
  EXPECT_EQ(finer.front().high, 0);
  EXPECT_DOUBLE_EQ(finer.front().share, 0.75);
  EXPECT_EQ(finer.back().low, 3);
  EXPECT_EQ(finer.back().high, 0);
  EXPECT_DOUBLE_EQ(finer.back().share, 0.25);
  const auto beyond = height_weights({0.5, 1.5}, {0.0, 1.0, 2.0});
  EXPECT_EQ(beyond[0].low, 0);
  EXPECT_EQ(beyond[0].share, 0.0);
  EXPECT_DOUBLE_EQ(beyond[1].share, 0.5);
  EXPECT_EQ(beyond[2].low, 1);
  EXPECT_EQ(beyond[2].share, 0.0);
}

/// On the same grid the fluid of the elastic case is the precursor's; only the projection's round-off may
/// differ.
TEST_F(RegridTest, EqualGridsAreCopied) {
  for (const double stretching : {0.0, 1.5}) {
    Physics rigid = support::rigid_channel({12, 8, 0, 14});
    rigid.grid.stretching = stretching;
    time::Setup source(rigid, world_.get());
    time::State precursor = time::perturbed_laminar(source);
    precursor.step = 7;
    const auto file = write(precursor, source);

    Physics elastic = support::elastic_channel({12, 8, 4, 14});
    elastic.grid.stretching = stretching;
    time::Setup target(elastic, world_.get());
    time::State state = start_from_precursor(file, initial(), target);
    EXPECT_EQ(state.step, 0);
    EXPECT_EQ(state.time, 0);
    const auto difference = [&](const grid::Field& a, const grid::Field& b) {
      return support::largest_difference(support::global_values(a, source.grid, 8, world_),
                                         support::global_values(b, source.grid, 8, world_));
    };
    EXPECT_LT(difference(state.velocity.x, precursor.velocity.x), 1e-13);
    EXPECT_LT(difference(state.velocity.y, precursor.velocity.y), 1e-13);
    EXPECT_LT(difference(state.velocity.z, precursor.velocity.z), 1e-13);
    EXPECT_EQ(difference(state.pressure, precursor.pressure), 0.0);
    EXPECT_LT(pressure::max_divergence(state.velocity, target.grid, target.decomposition), 1e-12);
    elastic.solid->formulation = SolidFormulation::kReferenceMap;
    time::Setup with_map(elastic, world_.get());
    time::State mapped = start_from_precursor(file, initial(), with_map);
    // The bands of the two begin in other rows, so the flow rate is summed in another order.
    EXPECT_LT(difference(mapped.velocity.x, state.velocity.x), 1e-14);
    EXPECT_EQ(
        support::largest_difference(support::global_values(mapped.material.phi, target.grid, 12, world_),
                                    support::global_values(state.material.phi, target.grid, 12, world_)),
        0.0);
    EXPECT_EQ(support::largest_difference(
                  support::global_values(state.material.phi, target.grid, 12, world_),
                  support::global_values(solid::flat_layer(target.grid, SolidFormulation::kTransportedB).phi,
                                         target.grid, 12, world_)),
              0.0);
  }
}

/// A smooth solenoidal flow that vanishes at the walls comes through with an error of second order.
TEST_F(RegridTest, OtherGridsGetSecondOrder) {
  constexpr double kTwoPi = 2 * std::numbers::pi;
  const auto u = [](double x, double y, double z) {
    return 1.5 * y * (2 - y) + 0.2 * std::sin(kTwoPi * z / 1.5) * y * (2 - y) + 0.0 * x;
  };
  const auto p = [](double x, double y, double z) {
    return std::cos(kTwoPi * x / 3) * std::cos(kTwoPi * z / 1.5) * std::cos(y * std::numbers::pi);
  };
  std::vector<double> u_errors, p_errors;
  for (const int n : {12, 24, 48}) {
    time::Setup source(support::rigid_channel({n, n, 0, n}), world_.get());
    time::State flow = time::state_at_rest(source.grid, std::nullopt);
    support::set_by_position(flow.velocity.x, source.grid, support::kFaceX, u);
    support::set_by_position(flow.pressure, source.grid, support::kCenter, p);
    time::Setup target(support::elastic_channel({n + 4, n + 2, (n + 2) / 4, n - 2}), world_.get());
    const time::State state = start_from_precursor(write(flow, source), initial(), target);
    const auto& g = target.grid;
    double u_error = 0, p_error = 0;
    for (int k = 0; k < g.nz; ++k) {
      for (int j = 0; j < g.ny_fluid; ++j) {
        for (int i = 0; i < g.nx; ++i) {
          const double x = (g.x_begin + i) * g.dx, z = (g.z_begin + k + 0.5) * g.dz;
          u_error = std::max(u_error, std::abs(state.velocity.x(i, j, k) - u(x, g.y_center[j], z)));
          p_error = std::max(p_error, std::abs(state.pressure(i, j, k) - p(x + g.dx / 2, g.y_center[j], z)));
        }
      }
    }
    u_errors.push_back(parallel::maximum(world_, u_error));
    p_errors.push_back(parallel::maximum(world_, p_error));
  }
  EXPECT_GT(support::last_order(u_errors), 1.8) << u_errors[0] << " " << u_errors[1] << " " << u_errors[2];
  EXPECT_GT(support::last_order(p_errors), 1.5) << p_errors[0] << " " << p_errors[1] << " " << p_errors[2];
}

TEST_F(RegridTest, AnotherPrecursorTimeOrBoxIsRefusedWithBothValues) {
  time::Setup source(support::rigid_channel({12, 8, 0, 12}), world_.get());
  time::State flow = time::state_at_rest(source.grid, std::nullopt);
  const auto file = write(flow, source);
  const auto message = [&](const InitialSpec& spec, const Physics& physics) -> std::string {
    time::Setup target(physics, world_.get());
    try {
      static_cast<void>(start_from_precursor(file, spec, target));
    } catch (const AgreedError& error) {
      EXPECT_EQ(error.code, ExitCode::kBadCase);
      return error.what();
    }
    return "accepted";
  };
  const Physics elastic = support::elastic_channel({12, 8, 4, 12});
  InitialSpec other = initial();
  other.precursor = "ffffffffffffffff";
  EXPECT_NE(message(other, elastic).find("ffffffffffffffff"), std::string::npos);
  EXPECT_NE(message(other, elastic).find(kCaseId), std::string::npos);
  InitialSpec later = initial();
  later.precursor_time = 2.5;
  EXPECT_NE(message(later, elastic).find("is of time 0.0"), std::string::npos);
  EXPECT_NE(message(later, elastic).find("has come to 2.5"), std::string::npos);
  Physics longer = elastic;
  longer.length_x = 4;
  EXPECT_NE(message(initial(), longer).find("length in x is 3"), std::string::npos);
}

}  // namespace
}  // namespace softwall::output
