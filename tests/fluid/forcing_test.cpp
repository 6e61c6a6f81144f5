#include "solver/fluid/forcing.hpp"

#include <gtest/gtest.h>

#include "solver/pressure/projection.hpp"
#include "tests/support/fields.hpp"

namespace softwall::fluid {
namespace {

using support::Domain;

/// sum((1 - phi) u dV) / sum((1 - phi) dV), phi averaged to the low-x face.
double bulk_velocity(const Domain& d, const grid::VectorField& velocity, const grid::Field& phi) {
  const auto& g = d.grid;
  const auto fluid = [&](int i, int j, int k) {
    return (1 - (phi(i, j, k) + phi(i - 1, j, k)) / 2) * g.dy[j];
  };
  const double volume = grid::sum_cells(grid::all_cells(g), fluid);
  const double flow = grid::sum_cells(
      grid::all_cells(g), [&](int i, int j, int k) { return fluid(i, j, k) * velocity.x(i, j, k); });
  return parallel::sum(d.decomposition.all(), flow) / parallel::sum(d.decomposition.all(), volume);
}

class Forcing : public testing::TestWithParam<double> {
 protected:
  Domain d{MPI_COMM_WORLD, {14, 10, 13}, {}, support::faces(10, 2.5, GetParam())};
  grid::Field phi{d.grid, 3};

  /// Fluid below first_row, solid from end_row on, between them noise.
  void set_fraction(int first_row, int end_row) {
    support::set_by_index(phi, d.grid, d.grid.ny, [=](int i, int j, int k) {
      if (j < first_row) return 0.0;
      return j < end_row ? (1 + support::noise(8, i, j, k)) / 2 : 1.0;
    });
    d.halo.fill({&phi});
  }
};

TEST_P(Forcing, HoldsTheFlowRateOfARigidChannel) {
  auto velocity = support::random_velocity(d, 3);
  for (const double wanted : {1.0, 0.0, -2.5}) {
    const double before = bulk_velocity(d, velocity, phi);
    const double added = hold_flow_rate(velocity, {}, wanted, d.grid, d.decomposition);
    EXPECT_NEAR(bulk_velocity(d, velocity, phi), wanted, 1e-14);
    EXPECT_NEAR(added, wanted - before, 1e-14);
  }
}

TEST_P(Forcing, CountsOnlyTheFluidOfAnElasticChannel) {
  const int first_row = 5;
  set_fraction(first_row, d.grid.ny);
  const grid::VectorField force(d.grid, 0);
  const SolidInput solid{&phi, &force, &force, first_row, 1};
  auto velocity = support::random_velocity(d, 3);
  static_cast<void>(hold_flow_rate(velocity, solid, 1.0, d.grid, d.decomposition));
  EXPECT_NEAR(bulk_velocity(d, velocity, phi), 1, 1e-14);
}

TEST_P(Forcing, NeedNotLookWhereNoFluidIs) {
  const int first_row = 5, end_row = 7;
  set_fraction(first_row, end_row);
  const grid::VectorField force(d.grid, 0);
  const SolidInput solid{&phi, &force, &force, first_row, 1, end_row};
  auto velocity = support::random_velocity(d, 3);
  static_cast<void>(hold_flow_rate(velocity, solid, 1.0, d.grid, d.decomposition));
  EXPECT_NEAR(bulk_velocity(d, velocity, phi), 1, 1e-14);
}

TEST_P(Forcing, AddsTheSameToEveryCellAndNothingElse) {
  auto velocity = support::random_velocity(d, 3);
  grid::VectorField before(d.grid, 1);
  support::copy(velocity, before);
  const double added = hold_flow_rate(velocity, {}, 1.0, d.grid, d.decomposition);
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = 0; j < d.grid.ny; ++j) {
      for (int i = 0; i < d.grid.nx; ++i) {
        ASSERT_DOUBLE_EQ(velocity.x(i, j, k), before.x(i, j, k) + added);
        ASSERT_EQ(velocity.y(i, j, k), before.y(i, j, k));
        ASSERT_EQ(velocity.z(i, j, k), before.z(i, j, k));
      }
    }
  }
}

/// Found before a projection, it is what is missing after it, with solid and without.
TEST_P(Forcing, IsKnownBeforeTheProjection) {
  const int first_row = 5;
  set_fraction(first_row, d.grid.ny);
  const grid::VectorField force(d.grid, 0);
  const double duration = 0.02;
  for (const SolidInput& solid : {SolidInput{}, SolidInput{&phi, &force, &force, first_row, 1}}) {
    auto velocity = support::random_velocity(d, 3);
    grid::Field pressure(d.grid, 1);
    pressure::Projection projection(d.grid, d.decomposition, d.halo);
    projection.find_psi(velocity, duration);
    const double push = flow_rate_correction({velocity.x, projection.psi(), duration, projection.row_sums()},
                                             solid, 1.0, d.grid, d.decomposition);
    EXPECT_GT(std::abs(push), 0.1);
    projection.correct(velocity, pressure, duration, push);
    grid::Field none(d.grid, 3);
    EXPECT_NEAR(bulk_velocity(d, velocity, solid.fraction ? phi : none), 1, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, Forcing, testing::Values(0.0, 1.8));

}  // namespace
}  // namespace softwall::fluid
