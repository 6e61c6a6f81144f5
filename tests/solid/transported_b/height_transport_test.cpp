#include "solver/solid/transported_b/height_transport.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "solver/solid/material.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/order.hpp"
#include "tests/support/round_off.hpp"

// phi as the share of each cell above a height: conserved, bounded, sharp for ever, and exact for small
// waves.
namespace softwall::solid {
namespace {

using support::Domain;
constexpr double kTurn = 2 * std::numbers::pi;

/// A layer on top of a box, carried by a velocity that is given.
class Layer {
 public:
  /// Without wave_speed nothing smooths the surface.
  Layer(MPI_Comm comm, Domain::Size n, Domain::Lengths length, const std::vector<double>& faces,
        double wave_speed = 0)
      : d(comm, n, length, faces),
        phi(d.grid, Material::kGhost),
        transport_(d.grid, d.halo, WenoWeights::kZ, wave_speed) {}

  /// eta(x, z): height of the surface over the centers of columns.
  template <class Height>
  void begin(const Height& eta) {
    const auto& g = d.grid;
    support::set_by_index(phi, g, g.ny, [&](int i, int j, int k) {
      const double share = (g.y_face[j + 1] - eta((i + 0.5) * g.dx, (k + 0.5) * g.dz)) / g.dy[j];
      return std::clamp(share, 0.0, 1.0);
    });
    follow();
  }
  void step(const grid::VectorField& velocity, double dt, int first_row = 0) {
    for (const Stage& stage : kRungeKutta3) {
      transport_.advance(phi, velocity, stage, dt, first_row);
      follow();
    }
  }
  /// Over all columns of all ranks, above y = 0.
  [[nodiscard]] std::vector<double> heights() const {
    const auto& g = d.grid;
    grid::Field copy(g, 0);
    const auto height = transport_.surface().view();
    const double zero = g.y_face[g.ny_fluid];
    grid::for_each_cell(grid::rows(g, 0, 1),
                        [&](int i, int j, int k) { copy(i, j, k) = Real(height(i, 0, k) + zero); });
    return support::global_values(copy, g, 1, d.decomposition.all());
  }
  [[nodiscard]] std::vector<double> values() const {
    return support::global_values(phi, d.grid, d.grid.ny, d.decomposition.all());
  }
  [[nodiscard]] double volume() const {
    const double here = grid::sum_cells(grid::all_cells(d.grid), [&](int i, int j, int k) {
      return phi(i, j, k) * d.grid.dy[j] / (double(d.grid.nx_global) * d.grid.nz_global);
    });
    return parallel::sum(d.decomposition.all(), here);
  }
  [[nodiscard]] const ColumnHeights& surface() const { return transport_.surface(); }

  Domain d;
  grid::Field phi;

 private:
  void follow() {
    d.halo.fill({&phi}, {0, d.grid.ny});
    transport_.follow(phi, 0);
  }
  HeightTransport transport_;
};

double wavy(double x, double z) {
  return 1.2 + 0.2 * std::sin(kTurn * x / 3) * std::cos(kTurn * z / 1.5) +
         0.1 * std::sin(2 * kTurn * z / 1.5);
}

class LayerUnderAHeight : public testing::TestWithParam<double> {
 protected:
  Layer layer{MPI_COMM_WORLD, {14, 12, 13}, {}, support::faces(12, 2, GetParam())};
};

TEST_P(LayerUnderAHeight, HeightsAreThoseOfTheColumnsVolume) {
  layer.begin(wavy);
  const auto& g = layer.d.grid;
  const auto seen = layer.heights();
  double error = 0;
  for (int k = 0; k < g.nz_global; ++k) {
    for (int i = 0; i < g.nx_global; ++i)
      error = std::max(error, std::abs(seen[static_cast<std::size_t>(k * g.nx_global + i)] -
                                       wavy((i + 0.5) * g.dx, (k + 0.5) * g.dz)));
  }
  EXPECT_LT(error, support::round_off(10));
}

/// The slopes within the columns move solid between cells, but none out of a column: whatever number of times
/// phi is put and taken, the heights stay.
TEST_P(LayerUnderAHeight, WithoutMotionTheHeightsStay) {
  layer.begin(wavy);
  const auto before = layer.heights();
  const grid::VectorField rest(layer.d.grid, 1);
  for (int n = 0; n < 20; ++n) layer.step(rest, 0.1);
  EXPECT_LT(support::largest_difference(layer.heights(), before), support::round_off(200));
}

/// A crest that reaches nearly to the wall beside a trough nearly at the bottom: a plane through both would
/// leave the rows.
TEST_P(LayerUnderAHeight, NothingIsLostBeyondTheWallOrBelowTheRows) {
  const auto& g = layer.d.grid;
  const double bottom = g.y_face[0], wall = g.y_face[g.ny];
  layer.begin([&](double x, double z) {
    const bool is_crest = (std::lround(x / g.dx - 0.5) + std::lround(z / g.dz - 0.5)) % 3 == 0;
    return is_crest ? wall - 0.02 : bottom + 0.03;
  });
  const auto before = layer.heights();
  const grid::VectorField rest(g, 1);
  for (int n = 0; n < 5; ++n) layer.step(rest, 0.1);
  EXPECT_LT(support::largest_difference(layer.heights(), before), support::round_off(200));
}

/// In a unit of time a wave along x decays by exp(-c (2 - 2 cos(2 pi / n))^3 / (60 dx)), n its length in
/// columns.
TEST(LayerUnderASmoothedHeight, LosesWavesOfAFewColumnsAndNoVolume) {
  constexpr double kSpeed = 0.7, kTime = 0.2, kHeight = 0.01;
  for (const int columns : {2, 4, 8}) {
    Layer layer{MPI_COMM_WORLD, {16, 12, 13}, {}, support::faces(12, 2, 0), kSpeed};
    const auto& g = layer.d.grid;
    const auto wave = [&](double x, double) {
      return 1.2 + kHeight * std::cos(kTurn * (x / g.dx - 0.5) / columns);
    };
    layer.begin(wave);
    const double volume = layer.volume(), before = layer.heights().front() - 1.2;
    const grid::VectorField rest(g, 1);
    for (int n = 0; n < 20; ++n) layer.step(rest, kTime / 20);
    const double rate = kSpeed * std::pow(2 - 2 * std::cos(kTurn / columns), 3) / (60 * g.dx);
    EXPECT_NEAR((layer.heights().front() - 1.2) / before, std::exp(-rate * kTime), 1e-3) << columns;
    EXPECT_NEAR(layer.volume(), volume, support::round_off(100));
  }
}

TEST_P(LayerUnderAHeight, AFlatSurfaceOnAFaceIsFoundThereExactly) {
  grid::VectorField velocity(layer.d.grid, 1);
  support::set_by_position(velocity.x, layer.d.grid, support::kFaceX,
                           [](double, double y, double) { return 0.7 * y; });
  layer.d.halo.fill({&velocity.x}, {0, 12});
  support::set_by_index(layer.phi, layer.d.grid, 12, [](int, int j, int) { return j < 7 ? 0 : 1; });
  layer.begin([&](double, double) { return layer.d.grid.y_face[7]; });
  const auto before = layer.values();
  for (int n = 0; n < 10; ++n) layer.step(velocity, 0.1);
  EXPECT_EQ(support::largest_difference(layer.values(), before), 0);
}

TEST_P(LayerUnderAHeight, VolumeIsConstantAndBoundsHoldInAnyFlow) {
  auto velocity = support::random_solenoidal_velocity(layer.d, 3);
  for (grid::Field* one : {&velocity.x, &velocity.y, &velocity.z}) {
    const auto q = one->view();
    const auto& g = layer.d.grid;
    grid::for_each_cell({-1, g.nx + 1, -1, g.ny + 1, -1, g.nz + 1},
                        [=](int i, int j, int k) { q(i, j, k) /= 10; });
  }
  layer.begin(wavy);
  const double before = layer.volume();
  for (int n = 0; n < 30; ++n) {
    layer.step(velocity, 0.05);
    ASSERT_NEAR(layer.volume(), before, support::round_off(50) * before);
  }
  for (const double value : layer.values()) {
    ASSERT_GE(value, 0);
    ASSERT_LE(value, 1);
  }
}

/// A wave moves with v however small it is and wherever in its row the surface lies. u = U(y) cos(k x), v =
/// the integral of k U sin(k x) from the surface to the top, one row of cells at a time.
TEST_P(LayerUnderAHeight, ASmallWaveMovesWithTheVelocityAtTheSurface) {
  constexpr double kSmall = 1e-6;
  const auto& g = layer.d.grid;
  grid::VectorField velocity(g, 1);
  support::set_by_index(velocity.x, g, g.ny, [&](int i, int j, int) {
    return kSmall * (2 - g.y_center[j]) * std::sin(kTurn * i / g.nx_global);
  });
  layer.d.halo.fill({&velocity.x}, {0, g.ny});
  for (const double surface : {g.y_face[6], g.y_face[6] + 0.3 * g.dy[6], g.y_face[6] + 0.97 * g.dy[6]}) {
    layer.begin([=](double, double) { return surface; });
    layer.step(velocity, 1);
    double depth_of_flow = (g.y_face[7] - surface) * (2 - g.y_center[6]);
    for (int j = 7; j < g.ny; ++j) depth_of_flow += g.dy[j] * (2 - g.y_center[j]);
    const auto seen = layer.heights();
    double error = 0;
    for (int i = 0; i < g.nx_global; ++i) {
      const double slope =
          (std::sin(kTurn * (i + 1) / g.nx_global) - std::sin(kTurn * i / g.nx_global)) / g.dx;
      error = std::max(
          error, std::abs(seen[static_cast<std::size_t>(i)] - surface - kSmall * slope * depth_of_flow));
    }
    EXPECT_LT(error, 1e-4 * kSmall + support::round_off(10));
  }
}

TEST_P(LayerUnderAHeight, NothingCrossesTheLowFaceOfTheFirstRow) {
  layer.begin([](double x, double z) { return 1.3 + (wavy(x, z) - 1.2) / 4; });
  const double before = layer.volume();
  const auto velocity = support::random_solenoidal_velocity(layer.d, 7);
  constexpr int kLowestRow = 4;
  for (int n = 0; n < 3; ++n) layer.step(velocity, 0.002, kLowestRow);
  EXPECT_NEAR(layer.volume(), before, support::round_off(50) * before);
  const auto& g = layer.d.grid;
  const double below = grid::max_cells(grid::rows(g, 0, kLowestRow), 0.0, layer.phi.view());
  EXPECT_EQ(below, 0);
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, LayerUnderAHeight, testing::Values(0.0, 1.5));

TEST(HeightTransport, AnyRanksCarryTheSame) {
  const auto after = [](MPI_Comm comm) {
    Layer layer(comm, {14, 12, 13}, {}, support::faces(12, 2, 1.5));
    const auto velocity = support::random_solenoidal_velocity(layer.d, 11);
    layer.begin(wavy);
    for (int n = 0; n < 10; ++n) layer.step(velocity, 0.003);
    return layer.values();
  };
  EXPECT_LT(support::largest_difference(after(MPI_COMM_WORLD), after(MPI_COMM_SELF)), 1e-11);
}

/// A wave that has travelled once around the box, along its diagonal; n cells in x and z.
double error_after_a_round(int n) {
  Layer layer(MPI_COMM_WORLD, {n, 16, n}, {1, 1}, support::faces(16, 1));
  const auto& g = layer.d.grid;
  grid::VectorField velocity(g, 1);
  grid::for_each_cell({-1, g.nx + 1, -1, g.ny + 1, -1, g.nz + 1}, [&](int i, int j, int k) {
    velocity.x(i, j, k) = 1;
    velocity.z(i, j, k) = -1;
  });
  layer.begin([](double x, double z) { return 0.5 + 0.2 * std::sin(kTurn * x) * std::cos(kTurn * z); });
  const auto before = layer.heights();
  const int steps = 4 * n;
  for (int step = 0; step < steps; ++step) layer.step(velocity, 1.0 / steps);
  return support::largest_difference(layer.heights(), before) / 0.2;
}

TEST(HeightTransport, AWaveArrivesAsItWasAndAsSharp) {
  const double coarse = error_after_a_round(12), fine = error_after_a_round(24);
  const double order = support::observed_order(coarse, fine);
  std::printf("[ measured ] wave after a round: error %.3g and %.3g, order %.2f\n", coarse, fine, order);
  EXPECT_GT(order, 3);
  EXPECT_LT(fine, 0.01);
}

}  // namespace
}  // namespace softwall::solid
