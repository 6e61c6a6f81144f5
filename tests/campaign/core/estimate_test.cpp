#include "campaign/core/estimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/campaign/core/examples.hpp"

namespace softwall::campaign {
namespace {

Case elastic_case(double G = 1.0, double viscosity_ratio = 1.0) {
  Case c = tests::campaign_of(tests::elastic_campaign()).cases.back().definition;
  c.physics.solid->G = G;
  c.physics.solid->viscosity_ratio = viscosity_ratio;
  return c;
}

TEST(Estimate, LimitsFollowTheirFormulas) {
  const Case c = elastic_case();  // 48 x (64 + 16) x 48 in 6 x 2.5 x 3, safety 0.7
  const double dx = 6.0 / 48, dy = 1.0 / 32, dz = 3.0 / 48;
  const StepLimits limits = step_limits(c.physics);
  EXPECT_NEAR(limits.convection, 0.7 * std::sqrt(3.0) / (1.3 / dx + 0.2 / dy + 0.2 / dz), 1e-12);
  const double along = 1 / (dx * dx) + 1 / (dz * dz), stretch = 1.5;
  EXPECT_NEAR(limits.elastic, 0.7 * 1.7 / (2 * std::sqrt(stretch * along)), 1e-12);
  EXPECT_NEAR(limits.viscosity, 0.7 * 2.51 * 2800 / (4 * (1 / (dx * dx) + 1 / (dy * dy) + 1 / (dz * dz))),
              1e-9);
  const double u_tau = 0.09 * std::pow(5600, 0.88) / 2800;  // Re_tau = 179
  EXPECT_NEAR(limits.accuracy, 0.4 / (2800 * u_tau * u_tau * 1.15), 1e-12);
  EXPECT_EQ(limits.smallest(), std::min({limits.convection, limits.elastic, limits.accuracy}));
  Case paper = c;
  paper.physics.solid->stiffness = Stiffness::kExplicit;
  EXPECT_NEAR(step_limits(paper.physics).elastic,
              0.7 * 0.86 / (2 * std::sqrt(stretch * (along + 1 / (dy * dy)))), 1e-12);
  EXPECT_EQ(step_limits(paper.physics).smallest(), step_limits(paper.physics).elastic);
}

TEST(Estimate, StifferOrMoreViscousLayersCostMore) {
  EXPECT_NEAR(step_limits(elastic_case(4.0).physics).elastic,  // B reaches 1.125 and 1.5
              step_limits(elastic_case(1.0).physics).elastic / std::sqrt(4 * 1.125 / 1.5), 1e-12);
  EXPECT_LT(step_limits(elastic_case(1, 10).physics).viscosity,
            step_limits(elastic_case().physics).viscosity / 2);
  Case paper = elastic_case();
  paper.physics.solid->stiffness = Stiffness::kExplicit;
  Case viscous = paper;
  viscous.physics.solid->viscosity_ratio = 10;
  EXPECT_NEAR(step_limits(viscous.physics).viscosity, step_limits(paper.physics).viscosity / 10, 1e-9);
  EXPECT_EQ(step_limits(elastic_case(1, 0.1).physics).viscosity,
            step_limits(elastic_case().physics).viscosity);
}

TEST(Estimate, RigidChannelsHaveNoElasticLimit) {
  const Case rigid = tests::campaign_of(tests::elastic_campaign()).cases.front().definition;
  EXPECT_TRUE(std::isinf(step_limits(rigid.physics).elastic));
  EXPECT_TRUE(std::isinf(step_limits(rigid.physics).accuracy));
  EXPECT_TRUE(std::isfinite(step_limits(rigid.physics).smallest()));
}

TEST(Estimate, CostIsStepsTimesCellsTimesSpeed) {
  Case c = elastic_case();
  c.physics.time_step.fixed_dt = 0.01;
  const Estimate whole = estimate(c, 500.0);
  EXPECT_EQ(whole.dt, 0.01);
  EXPECT_EQ(whole.steps, 5000.0);
  EXPECT_EQ(whole.cells, 48.0 * 80 * 48);
  EXPECT_NEAR(whole.core_hours, 5000.0 * 48 * 80 * 48 * 500e-9 / 3600, 1e-12);
  EXPECT_NEAR(estimate(c, 500.0, 25.0).core_hours, whole.core_hours / 2, 1e-9);
  EXPECT_EQ(estimate(c, 500.0, 60.0).core_hours, 0.0);
}

TEST(Estimate, StepsOfATenthMakeOne) {
  Case c = elastic_case();
  c.physics.time_step.fixed_dt = 0.1;
  c.run.end_time = 1;
  EXPECT_EQ(estimate(c, 500.0).steps, 10.0);
  EXPECT_EQ(estimate(c, 500.0, 0.7999999999999999).steps, 2.0);
  EXPECT_EQ(estimate(c, 500.0, 0.9999999999999999).steps, 0.0);
}

TEST(Estimate, SpeedsAssumedArePlausible) {
  Physics physics;
  for (const FlowType flow : {FlowType::kRigidChannel, FlowType::kElasticWall}) {
    physics.flow = flow;
    physics.precision = Precision::kDouble;
    const double in_double = default_ns_per_cell_step(physics);
    EXPECT_GT(in_double, 10.0);
    EXPECT_LT(in_double, 10000.0);
    physics.precision = Precision::kSingle;
    EXPECT_LT(default_ns_per_cell_step(physics), in_double);
  }
}

}  // namespace
}  // namespace softwall::campaign
