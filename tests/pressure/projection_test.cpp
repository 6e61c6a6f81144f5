#include "solver/pressure/projection.hpp"

#include <gtest/gtest.h>

#include "tests/support/fields.hpp"

namespace softwall::pressure {
namespace {

using support::Domain;
using support::global_values;

double velocity_difference(const grid::VectorField& a, const grid::VectorField& b, const Domain& d) {
  const auto whole = [&](const grid::Field& f) {
    return global_values(f, d.grid, d.grid.ny, d.decomposition.all());
  };
  return support::worse(support::largest_difference(whole(a.x), whole(b.x)),
                        support::worse(support::largest_difference(whole(a.y), whole(b.y)),
                                       support::largest_difference(whole(a.z), whole(b.z))));
}

void project(Domain& d, grid::VectorField& velocity, grid::Field& pressure, const Stage& stage, Real dt) {
  Projection projection(d.grid, d.decomposition, d.halo);
  projection.project(velocity, pressure, stage, dt);
  fluid::fill_ghosts(velocity, {}, d.halo);
}

class ProjectionOf : public testing::TestWithParam<double> {
 protected:
  Domain d{MPI_COMM_WORLD, {18, 12, 9}, {}, support::faces(12, 2.5, GetParam())};
  grid::Field pressure{d.grid, 1};
};

TEST_P(ProjectionOf, RandomVelocityHasNoDivergenceLeft) {
  for (const Stage& stage : kRungeKutta3) {
    for (const Real dt : {1e-3, 1.0}) {
      auto velocity = support::random_velocity(d, 3);
      ASSERT_GT(max_divergence(velocity, d.grid, d.decomposition), 1);
      project(d, velocity, pressure, stage, dt);
      EXPECT_LT(max_divergence(velocity, d.grid, d.decomposition), 1e-12 / d.grid.dx);
    }
  }
}

TEST_P(ProjectionOf, LeavesGhostCellsInXRight) {
  auto velocity = support::random_velocity(d, 3);
  Projection(d.grid, d.decomposition, d.halo).project(velocity, pressure, kRungeKutta3[0], 0.1);
  grid::VectorField wanted(d.grid, 1);
  support::copy(velocity, wanted);
  d.halo.fill({&wanted.x, &wanted.y, &wanted.z}, {0, d.grid.ny});
  for (const auto component : {&grid::VectorField::x, &grid::VectorField::y, &grid::VectorField::z}) {
    const auto found = (velocity.*component).view(), right = (wanted.*component).view();
    for (const int i : {-1, d.grid.nx}) {
      for (int k = 0; k < d.grid.nz; ++k) {
        for (int j = 0; j < d.grid.ny; ++j)
          ASSERT_EQ(found(i, j, k), right(i, j, k)) << i << " " << j << " " << k;
      }
    }
  }
}

TEST_P(ProjectionOf, DivergenceFreeVelocityChangesNothing) {
  auto velocity = support::random_solenoidal_velocity(d, 3);
  grid::VectorField before(d.grid, 1);
  support::copy(velocity, before);
  project(d, velocity, pressure, kRungeKutta3[1], 0.5);
  EXPECT_LT(velocity_difference(velocity, before, d), 1e-14);
  EXPECT_LT(support::largest(global_values(pressure, d.grid, d.grid.ny, d.decomposition.all())), 1e-13);
}

TEST_P(ProjectionOf, GradientIsTakenIntoThePressure) {
  const auto& g = d.grid;
  grid::Field q(g, 1);
  support::set_by_index(q, g, g.ny, [](int i, int j, int k) { return support::noise(9, i, j, k); });
  const double volume = double(g.nx_global) * g.nz_global * g.height;
  const double mean =
      parallel::sum(
          d.decomposition.all(),
          grid::sum_cells(grid::all_cells(g), [&](int i, int j, int k) { return q(i, j, k) * g.dy[j]; })) /
      volume;
  grid::for_each_cell(grid::all_cells(g), [&](int i, int j, int k) { q(i, j, k) -= mean; });
  fluid::fill_ghosts(q, d.halo);
  const Stage stage = kRungeKutta3[2];
  const Real dt = 0.1, duration = 2 * stage.alpha * dt;
  const auto solenoidal = support::random_solenoidal_velocity(d, 3);
  grid::VectorField velocity(g, 1);
  support::copy(solenoidal, velocity);
  grid::for_each_cell(grid::all_cells(g), [&](int i, int j, int k) {
    velocity.x(i, j, k) += duration * (q(i, j, k) - q(i - 1, j, k)) / g.dx;
    if (j > 0) velocity.y(i, j, k) += duration * (q(i, j, k) - q(i, j - 1, k)) / g.dy_face[j];
    velocity.z(i, j, k) += duration * (q(i, j, k) - q(i, j, k - 1)) / g.dz;
  });
  fluid::fill_ghosts(velocity, {}, d.halo);
  support::set_by_index(pressure, g, g.ny, [](int, int, int) { return 2.0; });  // p is added to, not replaced
  project(d, velocity, pressure, stage, dt);
  EXPECT_LT(velocity_difference(velocity, solenoidal, d), 1e-13);
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) ASSERT_NEAR(pressure(i, j, k), 2 + q(i, j, k), 1e-11);
    }
  }
}

TEST_P(ProjectionOf, LeavesTheMeanFlowAlone) {
  const auto& g = d.grid;
  auto velocity = support::random_velocity(d, 5);
  const auto flow = [&](int j, const grid::Field& f) {
    return parallel::sum(
        d.decomposition.all(),
        grid::sum_cells(grid::rows(g, j, j + 1), [&](int i, int, int k) { return f(i, j, k); }));
  };
  std::vector<double> before;
  for (int j = 0; j < g.ny; ++j) before.push_back(flow(j, velocity.x));
  project(d, velocity, pressure, kRungeKutta3[0], 0.2);
  for (int j = 0; j < g.ny; ++j) EXPECT_NEAR(flow(j, velocity.x), before[static_cast<std::size_t>(j)], 1e-12);
  for (int j = 0; j < g.ny; ++j) EXPECT_NEAR(flow(j, velocity.y), 0, 1e-12) << "net flow through row " << j;
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, ProjectionOf, testing::Values(0.0, 1.8));

}  // namespace
}  // namespace softwall::pressure
