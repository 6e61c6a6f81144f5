#include <gtest/gtest.h>

#include <string>

#include "solver/case/step_limits.hpp"
#include "solver/fluid/stability.hpp"
#include "tests/support/flows.hpp"

namespace softwall::time {
namespace {

std::string limit_of(const Physics& p, double speed) {
  time::Setup setup(p, MPI_COMM_WORLD);
  State s = support::smooth_state(setup);
  grid::for_each_cell(grid::all_cells(setup.grid),
                      [&](int i, int j, int k) { s.velocity.x(i, j, k) *= speed; });
  return choose_time_step(s, setup).limit;
}

TEST(TimeStep, FollowsWhatBinds) {
  Physics rigid = support::rigid_channel({12, 12, 0, 8});
  rigid.reynolds = 1e5;
  EXPECT_EQ(limit_of(rigid, 1), "convection");
  rigid.reynolds = 0.5;
  EXPECT_EQ(limit_of(rigid, 1), "viscosity");

  Physics elastic = support::elastic_channel({12, 16, 4, 8});
  elastic.reynolds = 1e5;
  elastic.solid->G = 1e3;
  EXPECT_EQ(limit_of(elastic, 1), "elastic");
  elastic.solid->G = 1e-3;
  EXPECT_EQ(limit_of(elastic, 1), "convection");
  elastic.reynolds = 100;
  elastic.solid->viscosity_ratio = 1e3;
  EXPECT_EQ(limit_of(elastic, 1), "viscosity");
}

TEST(TimeStep, IsTheFixedOneWhenTheCaseSaysSo) {
  Physics p = support::rigid_channel({12, 12, 0, 8});
  p.time_step.fixed_dt = 0.0125;
  time::Setup setup(p, MPI_COMM_WORLD);
  const State s = support::smooth_state(setup);
  EXPECT_EQ(choose_time_step(s, setup).dt, 0.0125);
  EXPECT_STREQ(choose_time_step(s, setup).limit, "fixed");
}

TEST(TimeStep, IsTheStabilityLimitTimesSafety) {
  Physics p = support::elastic_channel({12, 16, 4, 8});
  p.solid->G = 50;
  time::Setup setup(p, MPI_COMM_WORLD);
  const State s = support::smooth_state(setup);
  const auto solid = setup.solid->input(s.material);
  const double smallest = std::min(
      {step_limits::convection(fluid::convection_rate(s.velocity, setup.grid, setup.decomposition)),
       fluid::viscosity_limit(setup.viscosity, solid, setup.grid), setup.solid->elastic_limit(s.material)});
  EXPECT_DOUBLE_EQ(choose_time_step(s, setup).dt, 0.8 * smallest);
}

TEST(TimeStep, OfAnElasticChannelIsNoLongerThanTheViscousTimeAsked) {
  Physics p = support::elastic_channel({12, 16, 4, 8});
  p.reynolds = 100;
  p.solid->G = 1e-3;
  p.solid->dt_plus = 0.25;
  time::Setup setup(p, MPI_COMM_WORLD);
  State s = support::smooth_state(setup);
  const double stable = choose_time_step(s, setup).dt;  // nothing drives it yet
  s.driving_gradient = 0.25 / (100 * stable / 2);
  EXPECT_DOUBLE_EQ(choose_time_step(s, setup).dt, stable / 2);
  EXPECT_STREQ(choose_time_step(s, setup).limit, "accuracy");
  s.driving_gradient /= 4;
  EXPECT_EQ(choose_time_step(s, setup).dt, stable);
}

TEST(TimeStep, OfAnUndeformedLayerIsThatOfItsStiffestShearWave) {
  // omega^2 = 4 G (1/dx^2 + 1/dy^2 + 1/dz^2) for B = I, limit 0.86 / omega; implicit between rows: 1.7, and
  // the waves along x and z alone.
  for (const auto stiffness : {Stiffness::kExplicit, Stiffness::kImplicit}) {
    Physics p = support::elastic_channel({12, 16, 4, 8});
    p.solid->stiffness = stiffness;
    time::Setup setup(p, MPI_COMM_WORLD);
    State s = state_at_rest(setup.grid, SolidFormulation::kTransportedB);
    start(s, setup);
    const auto& g = setup.grid;
    const bool implicit = stiffness == Stiffness::kImplicit;
    const double inv_dy = implicit ? 0 : 1 / g.dy[g.ny - 1],
                 omega = 2 * std::sqrt(1 / (g.dx * g.dx) + inv_dy * inv_dy + 1 / (g.dz * g.dz));
    EXPECT_NEAR(setup.solid->elastic_limit(s.material), (implicit ? 1.7 : 0.86) / omega, 1e-12);
  }
}

TEST(TimeStep, LimitsAreStableInDeed) {
  // At 95 % of every limit nothing grows: a channel with a stiff layer, its waves kicked at all lengths.
  for (const double reynolds : {2.0, 1e4})
    for (const auto stiffness : {Stiffness::kExplicit, Stiffness::kImplicit})
      for (const double viscosity_ratio : {1.0, 10.0})
        for (const auto formulation : support::kBothFormulations) {
          Physics p = support::formulated(support::elastic_channel({12, 12, 4, 8}), formulation);
          p.reynolds = reynolds;
          p.time_step.safety = 0.95;
          p.solid->G = 10;
          p.solid->stiffness = stiffness;
          p.solid->viscosity_ratio = viscosity_ratio;
          time::Setup setup(p, MPI_COMM_WORLD);
          setup.bulk_velocity.reset();
          State s = state_at_rest(setup);
          const auto& g = setup.grid;
          support::set_by_index(s.velocity.x, g, g.ny,
                                [](int i, int j, int k) { return 1e-3 * support::noise(1, i, j, k); });
          support::set_by_index(s.velocity.z, g, g.ny,
                                [](int i, int j, int k) { return 1e-3 * support::noise(2, i, j, k); });
          fluid::fill_ghosts(s.velocity, setup.walls, setup.halo);
          grid::Field unused(g, 1);
          setup.projection->project(s.velocity, unused, kRungeKutta3[0], 1.0);
          start(s, setup);
          for (int step = 0; step < 250; ++step) advance(s, setup, choose_time_step(s, setup).dt);
          EXPECT_LT(support::largest(support::all_velocity(s, setup)), 2e-3)
              << "Re = " << reynolds << ", " << support::name_of(formulation) << ", viscosity ratio "
              << viscosity_ratio << (stiffness == Stiffness::kImplicit ? ", implicit" : ", explicit");
        }
}

}  // namespace
}  // namespace softwall::time
