#include <gtest/gtest.h>

#include "solver/statistics/statistics.hpp"
#include "tests/statistics/flows.hpp"

/// In a steady flow the total stress is the straight line wall_shear_bottom - P y, through fluid and solid.
namespace softwall::statistics {
namespace {

using namespace testing;

/// Runs a laminar channel to `end` and averages over the last 0.1.
analysis::BlockStatistics steady(Physics physics, double end) {
  physics.reynolds = 1;
  physics.grid.nx = physics.grid.nz = 4;
  physics.grid.ny_fluid = 8;
  physics.time_step.safety = 0.8;
  physics.initial.amplitude = 0;
  physics.statistics = {.start_time = end - 0.1, .interval_steps = 2, .block_length = 1};
  time::Setup setup(physics, MPI_COMM_WORLD);
  Statistics statistics(setup);
  auto s = time::perturbed_laminar(setup);
  while (s.time < end) {
    const double dt = time::choose_time_step(s, setup).dt;
    time::advance(s, setup, dt);
    statistics.sample_step(s, dt);
  }
  return statistics.blocks();
}

double at(const analysis::BlockStatistics& b, const std::string& profile, std::size_t j) {
  return b.profiles.at(profile).values[j];
}

TEST(StressBalance, OfALaminarChannelIsAStraightLine) {
  const auto b = steady(rigid_case(), 14);
  ASSERT_EQ(b.blocks(), 1u);
  const double shear = b.series.at("wall_shear_bottom")[0], P = b.series.at("driving_gradient")[0];
  EXPECT_NEAR(shear, P, 1e-9);
  EXPECT_NEAR(b.series.at("wall_shear_top")[0], shear, 1e-9);
  EXPECT_NEAR(shear, 3, 0.2);  // nu dU/dy = 3 nu U_b / h, on eight rows
  for (std::size_t j = 0; j < b.y_face.size(); ++j) {
    EXPECT_NEAR(at(b, "viscous_stress", j) - at(b, "uv", j), shear - P * b.y_face[j], 1e-9) << j;
  }
}

TEST(StressBalance, WithALayerRunsThroughTheSolidToTheUpperWall) {
  auto physics = elastic_case();
  physics.layer_height = 1;
  physics.solid->G = 5;
  const auto b = steady(physics, 32);
  ASSERT_EQ(b.blocks(), 1u);
  const double shear = b.series.at("wall_shear_bottom")[0], P = b.series.at("driving_gradient")[0];
  const std::size_t top = b.y_face.size() - 1;
  for (std::size_t j = 0; j <= top; ++j) {
    const double total = at(b, "viscous_stress", j) - at(b, "uv", j) + at(b, "elastic_stress", j);
    EXPECT_NEAR(total, shear - P * b.y_face[j], 1e-7) << j;
  }
  EXPECT_NEAR(b.series.at("wall_shear_top")[0], 0, 1e-7);  // the solid at rest: all of it elastic
  EXPECT_NEAR(at(b, "elastic_stress", top), shear - 3 * P, 1e-7);
  EXPECT_LT(at(b, "elastic_stress", top), -3);
  EXPECT_EQ(at(b, "elastic_stress", 3), 0);
  EXPECT_NEAR(b.series.at("interface_mean")[0], 2, 1e-10);
  EXPECT_NEAR(b.series.at("interface_rms")[0], 0, 1e-10);
  EXPECT_NEAR(b.series.at("bulk_velocity")[0], 1, 1e-13);
  // Simple shear: B_xx = 1 + B_xy^2, the mean of the squares on the edges around the center.
  const double above = at(b, "elastic_stress", top) / 5, below = at(b, "elastic_stress", top - 1) / 5;
  EXPECT_NEAR(at(b, "elastic_xx", top - 1) / 5, 1 + (above * above + below * below) / 2, 1e-4);
  EXPECT_NEAR(at(b, "elastic_yy", top - 1), 5, 1e-12);
  EXPECT_LT(b.series.at("min_eigenvalue")[0], 0.7);
}

}  // namespace
}  // namespace softwall::statistics
