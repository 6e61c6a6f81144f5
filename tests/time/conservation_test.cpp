#include <gtest/gtest.h>

#include "tests/support/flows.hpp"

// What a run may not lose or make.
namespace softwall::time {
namespace {

double solid_volume(const State& s, const Setup& setup) {
  const auto& g = setup.grid;
  const double here = grid::sum_cells(grid::all_cells(g),
                                      [&](int i, int j, int k) { return s.material.phi(i, j, k) * g.dy[j]; });
  return parallel::sum(setup.decomposition.all(), here);
}

class Run : public testing::TestWithParam<double> {
 protected:
  static Physics physics() {
    Physics p = support::elastic_channel({12, 16, 6, 8});
    p.grid.stretching = GetParam();
    if (GetParam() > 0) p.layer_height = 0.5;
    p.reynolds = 300;
    return p;
  }
};

TEST_P(Run, KeepsTheVolumeOfTheSolidWhileTheInterfaceMoves) {
  time::Setup setup(physics(), MPI_COMM_WORLD);
  State s = support::smooth_state(setup);
  const double before = solid_volume(s, setup);
  double roughest = 0;
  for (int step = 0; step < 60; ++step) {
    advance(s, setup, choose_time_step(s, setup).dt);
    ASSERT_NEAR(solid_volume(s, setup), before, 2e-14 * before) << "step " << step;
    const int j = setup.grid.ny_fluid;
    roughest = support::worse(roughest, 1 - s.material.phi(0, j, 0));
  }
  EXPECT_GT(parallel::maximum(setup.decomposition.all(), roughest), 0.1) << "the interface hardly moved";
}

TEST_P(Run, HoldsTheFlowRateOfTheFluidAndTheDivergence) {
  time::Setup setup(physics(), MPI_COMM_WORLD);
  State s = support::smooth_state(setup);
  const auto& g = setup.grid;
  const auto fluid = [&](int i, int j, int k) {
    return (1 - (s.material.phi(i, j, k) + s.material.phi(i - 1, j, k)) / 2) * g.dy[j];
  };
  const auto total = [&](const auto& f) {
    return parallel::sum(setup.decomposition.all(), grid::sum_cells(grid::all_cells(g), f));
  };
  for (int step = 0; step < 30; ++step) {
    advance(s, setup, choose_time_step(s, setup).dt);
    const double flow = total([&](int i, int j, int k) { return fluid(i, j, k) * s.velocity.x(i, j, k); });
    ASSERT_NEAR(flow / total(fluid), 1, 1e-5);  // dust below the band, at most 1e-3 a cell, is not counted
    ASSERT_LT(pressure::max_divergence(s.velocity, g, setup.decomposition), 1e-12 / g.dx);
  }
}

TEST_P(Run, StaysFinite) {
  time::Setup setup(physics(), MPI_COMM_WORLD);
  State s = support::smooth_state(setup);
  EXPECT_TRUE(is_finite(s, setup.decomposition));
  if (setup.decomposition.all().rank() == setup.decomposition.all().size() - 1)
    s.material.B.xz(1, setup.grid.ny - 1, 1) = NAN;
  EXPECT_FALSE(is_finite(s, setup.decomposition));  // all ranks hear of it
}

TEST_P(Run, MomentumChangesOnlyThroughTheWallsAndTheDriving) {
  // Elastic and viscous stresses act between cells: summed over the box only the walls remain. One step from
  // a flow without stress in the solid: dM/dt = P V - friction of both walls, third-order average over the
  // step.
  time::Setup setup(physics(), MPI_COMM_WORLD);
  setup.bulk_velocity.reset();
  State s = support::smooth_state(setup);
  const auto& g = setup.grid;
  const auto momentum = [&] {
    return parallel::sum(setup.decomposition.all(),
                         grid::sum_cells(grid::all_cells(g), [&](int i, int j, int k) {
                           return s.velocity.x(i, j, k) * g.dy[j];
                         }));
  };
  const auto friction = [&] {
    const double nu = setup.viscosity;
    const double bottom = grid::sum_cells(
        grid::rows(g, 0, 1), [&](int i, int, int k) { return 2 * nu * s.velocity.x(i, 0, k) * g.inv_dy[0]; });
    const auto& B = s.material.B;
    const double top = grid::sum_cells(grid::rows(g, 0, 1), [&](int i, int, int k) {
      const double viscous = 2 * nu * s.velocity.x(i, g.ny - 1, k) * g.inv_dy[g.ny - 1];
      return viscous - setup.physics.solid->G * B.xy(i, g.ny, k);
    });
    return parallel::sum(setup.decomposition.all(), bottom + top);
  };
  const double dt = 2e-3;
  double change = 0, impulse = 0;
  const double start_momentum = momentum();
  for (int step = 0; step < 50; ++step) {
    const double before = friction();
    advance(s, setup, dt);
    impulse -= dt * (before + friction()) / 2;  // trapezoidal
  }
  change = momentum() - start_momentum;
  EXPECT_GT(std::abs(change), 1e-3);
  EXPECT_NEAR(change, impulse, 1e-3 * std::abs(change));
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, Run, testing::Values(0.0, 1.2));

}  // namespace
}  // namespace softwall::time
