#include "analysis/stress_balance.hpp"

#include <gtest/gtest.h>

#include "samples.hpp"

namespace softwall::analysis {
namespace {

/// Stresses that add up to the straight line 0.005 - 0.007 y, however they are shared.
BlockStatistics balanced() {
  BlockStatistics s;
  s.reynolds = 2800.0;
  s.elastic = true;
  samples::set_uniform_grid(s, 2.5, 50);
  samples::set_blocks(s, 2);
  const auto solid = [](double y) { return y > 2.0 ? 1.0 : 0.0; };
  samples::add_profile(s, "viscous_stress", Location::kFace, [](double y, std::size_t) { return 0.001 * y; });
  samples::add_profile(s, "elastic_stress", Location::kFace,
                       [&](double y, std::size_t) { return -0.003 * solid(y); });
  samples::add_profile(s, "uv", Location::kFace, [&](double y, std::size_t) {
    return 0.001 * y - 0.003 * solid(y) - (0.005 - 0.007 * y);
  });
  s.series["driving_gradient"] = {0.006, 0.008};
  s.series["wall_shear_bottom"] = {0.004, 0.006};
  return s;
}

TEST(StressBalance, VanishesWhenTheStressesAddUp) {
  const BlockStatistics s = balanced();
  EXPECT_NEAR(stress_balance_residual(s, s.weight), 0.0, 1e-14);
}

TEST(StressBalance, SeesAMissingStress) {
  BlockStatistics s = balanced();
  for (double& value : s.profiles["elastic_stress"].values) value = 0.0;
  // -0.003 is missing over the upper fifth of the height (less half a cell at the jump).
  EXPECT_NEAR(stress_balance_residual(s, s.weight), 0.003 / 0.005 * std::sqrt(0.2), 0.02);
}

TEST(StressBalance, IsNotANumberWithoutTheProfiles) {
  BlockStatistics s = balanced();
  s.profiles.erase("uv");
  EXPECT_TRUE(std::isnan(stress_balance_residual(s, s.weight)));
}

}  // namespace
}  // namespace softwall::analysis
