#include "analysis/derived.hpp"

#include <gtest/gtest.h>

#include "samples.hpp"

namespace softwall::analysis {
namespace {

using samples::ElasticModel;

BlockStatistics rigid_statistics(const std::function<double(double)>& u, double wall_shear, int blocks,
                                 int cells = 128) {
  BlockStatistics s;
  s.reynolds = 2800.0;
  samples::set_uniform_grid(s, 2.0, cells);
  samples::set_blocks(s, blocks);
  samples::add_profile(s, "u", Location::kCenter, [&](double y, std::size_t) { return u(y); });
  s.series["driving_gradient"].assign(blocks, wall_shear);
  s.series["wall_shear_bottom"].assign(blocks, wall_shear);
  return s;
}

TEST(Derived, ManufacturedElasticChannelGivesItsNumbersBack) {
  const ElasticModel model;
  const DerivedQuantities q = derive(samples::elastic_statistics(model, 20));
  EXPECT_NEAR(q.re_tau_w.value, model.re_tau_w, 1e-9);
  EXPECT_NEAR(q.re_tau.value, model.re_tau, 1e-9);
  EXPECT_NEAR(q.u_max.value, model.u_max(), 1e-9);
  EXPECT_NEAR(q.y_max.value, model.y_max, 1e-9);
  EXPECT_NEAR(q.d.value, model.d, 5e-4);
  EXPECT_NEAR(q.k_plus_dk.value, model.k_plus_dk, 1e-3);
  EXPECT_NEAR(q.delta_u_plus.value, model.delta_u_plus, 0.05);
  EXPECT_DOUBLE_EQ(q.delta_max.value, 0.095);
  EXPECT_DOUBLE_EQ(q.delta_rms.value, 0.025);
  EXPECT_DOUBLE_EQ(q.log_range_low_plus, LogLawOptions{}.low_plus);
  EXPECT_NEAR(q.log_range_high_plus, 0.5 * 1.206 * 240.5, 1e-6);
  EXPECT_NEAR(q.log_intercept, 5.5 - q.delta_u_plus.value, 1e-12);
  EXPECT_EQ(q.blocks, 20);
  EXPECT_EQ(q.window_start, 100.0);
  EXPECT_EQ(q.window_end, 140.0);
  EXPECT_EQ(q.note, "");
}

/// A channel whose friction and profile wander from block to block, as a real one's do.
BlockStatistics noisy_statistics(const ElasticModel& model, std::mt19937_64& random, int blocks) {
  BlockStatistics s = samples::elastic_statistics(model, blocks);
  const double rho = 0.4;
  const auto bottom = samples::autoregressive(random, blocks, rho);
  const auto gradient = samples::autoregressive(random, blocks, rho);
  const auto large_scale = samples::autoregressive(random, blocks, rho);
  const auto small_scale = samples::autoregressive(random, blocks, rho);
  for (int b = 0; b < blocks; ++b) {
    s.series["wall_shear_bottom"][b] *= 1.0 + 0.05 * bottom[b];
    s.series["driving_gradient"][b] *= 1.0 + 0.05 * gradient[b];
  }
  samples::add_profile(s, "u", Location::kCenter, [&](double y, std::size_t b) {
    return model.u(y) + 0.01 * large_scale[b] * std::sin(M_PI * y / 2.5) +
           0.005 * small_scale[b] * std::sin(3.0 * M_PI * y / 2.5);
  });
  return s;
}

TEST(Derived, IntervalsHoldTheTruth) {
  const ElasticModel model;
  const std::map<std::string_view, double> truth = {{"re_tau_w", model.re_tau_w},
                                                    {"re_tau", model.re_tau},
                                                    {"u_max", model.u_max()},
                                                    {"y_max", model.y_max},
                                                    {"k_plus_dk", model.k_plus_dk},
                                                    {"d", model.d},
                                                    {"delta_u_plus", model.delta_u_plus}};
  std::map<std::string_view, int> given, covered;
  std::mt19937_64 random(11);
  const int windows = 250;
  for (int i = 0; i < windows; ++i) {
    const DerivedQuantities q = derive(noisy_statistics(model, random, 64));
    for (const auto& [name, member] : kMeasuredMembers) {
      const Measured& measured = q.*member;
      if (!measured.ci95 || !truth.contains(name)) continue;
      ++given[name];
      covered[name] += std::fabs(measured.value - truth.at(name)) <= *measured.ci95;
    }
  }
  for (const auto& [name, value] : truth) {
    EXPECT_GT(given[name], 0.8 * windows) << name;
    EXPECT_GT(covered[name], 0.89 * given[name])
        << name;  // 95 % less three standard errors of this experiment
    EXPECT_LT(covered[name], 0.995 * given[name]) << name;
  }
}

TEST(Derived, LaminarPoiseuille) {
  const auto q = derive(rigid_statistics([](double y) { return 1.5 * y * (2.0 - y); }, 3.0 / 2800.0, 10));
  EXPECT_NEAR(q.re_tau_w.value, std::sqrt(3.0 * 2800.0), 1e-9);
  EXPECT_NEAR(q.re_tau.value, q.re_tau_w.value, 1e-9);
  EXPECT_NEAR(q.u_max.value, 1.5, 1e-12);
  EXPECT_NEAR(q.y_max.value, 0.0, 1e-12);
  EXPECT_TRUE(std::isnan(q.k_plus_dk.value));
}

TEST(Derived, MoserKimMansourChannel) {
  const auto columns = samples::read_columns("mkm180_profiles_bulk.csv");
  const auto& y = columns[0];
  const auto& u = columns[2];
  const auto profile = [&](double at) {
    const double from_wall = std::fmin(at, 2.0 - at);
    const auto above = std::lower_bound(y.begin() + 1, y.end() - 1, from_wall) - y.begin();
    const double share = (from_wall - y[above - 1]) / (y[above] - y[above - 1]);
    return u[above - 1] + share * (u[above] - u[above - 1]);
  };
  const double u_tau = 0.063774;
  BlockStatistics s = rigid_statistics(profile, u_tau * u_tau, 10);
  s.reynolds = 2792.98;
  const DerivedQuantities q = derive(s);
  EXPECT_NEAR(q.re_tau_w.value, 178.12, 0.02);
  EXPECT_NEAR(q.re_tau.value, 178.12, 0.02);
  EXPECT_NEAR(q.u_max.value, 1.1671, 1e-3);
  EXPECT_NEAR(q.y_max.value, 0.0, 0.01);
  EXPECT_NEAR(q.k_plus_dk.value, 0.40, 0.03);
  EXPECT_NEAR(q.delta_u_plus.value, 0.0, 0.8);
  EXPECT_TRUE(std::isnan(q.d.value) && std::isnan(q.delta_max.value) && std::isnan(q.delta_rms.value));
  EXPECT_FALSE(q.d.ci95);
}

TEST(Derived, PartialLastBlockWeighsWhatItSampled) {
  BlockStatistics s = samples::elastic_statistics({}, 3);
  s.series["wall_shear_bottom"] = {0.004, 0.005, 0.008};
  s.weight = {2.0, 2.0, 0.5};
  const double mean = (2.0 * 0.004 + 2.0 * 0.005 + 0.5 * 0.008) / 4.5;
  const DerivedQuantities q = derive(s);
  EXPECT_NEAR(q.re_tau_w.value, 2800.0 * std::sqrt(mean), 1e-10);
  EXPECT_DOUBLE_EQ(q.sampled_time, 4.5);
  EXPECT_DOUBLE_EQ(q.window_end, 104.5);
}

TEST(Derived, InterfaceRmsIsTheRootOfTheMeanSquare) {
  BlockStatistics s = samples::elastic_statistics({}, 2);
  s.series["interface_rms"] = {0.02, 0.04};
  s.series["interface_variance"] = {0.0004, 0.0016};
  EXPECT_DOUBLE_EQ(derive(s).delta_rms.value, std::sqrt(0.001));
}

TEST(Derived, TheLogLawOfASoftWallBeginsAtItsMeanCrest) {
  const ElasticModel model;
  BlockStatistics s = samples::elastic_statistics(model, 2);
  s.series["interface_max"].assign(2, 0.2);
  const DerivedQuantities q = derive(s);
  EXPECT_NEAR(q.log_range_low_plus, 0.2 * model.re_tau, 1e-9);
  EXPECT_NEAR(q.k_plus_dk.value, model.k_plus_dk, 1e-3);
  s.series["interface_max"].assign(2, 0.5);  // the range ends at 0.6
  EXPECT_TRUE(std::isnan(derive(s).k_plus_dk.value));
}

TEST(Derived, WindowLeavesEarlierBlocksOut) {
  BlockStatistics s = samples::elastic_statistics({}, 20);
  s.series["wall_shear_bottom"][0] = s.series["wall_shear_bottom"][1] = 1.0;  // a transient
  DeriveOptions options;
  options.window_start = 104.0 + 1e-10;  // a block that starts at it but for round-off belongs to it
  const DerivedQuantities q = derive(s, options);
  EXPECT_NEAR(q.re_tau_w.value, 193.0, 1e-9);
  EXPECT_EQ(q.blocks, 18);
  EXPECT_EQ(q.window_start, 104.0);
  EXPECT_EQ(q.window_asked, *options.window_start);
  EXPECT_EQ(q.note.find("blocks were kept"), std::string::npos) << q.note;
  options.window_start = 1000.0;
  EXPECT_THROW((void)derive(s, options), std::runtime_error);
}

TEST(Derived, SaysWhichBlocksWereNeverKept) {
  DeriveOptions options;
  options.window_start = 50.0;
  const DerivedQuantities q = derive(samples::elastic_statistics({}, 20), options);
  EXPECT_EQ(q.window_start, 100.0);
  EXPECT_NE(q.note.find("averages were asked for from t = 50, blocks were kept from 100"), std::string::npos)
      << q.note;
}

TEST(Derived, ShortWindowGivesNoIntervalAndSaysSo) {
  const DerivedQuantities q = derive(samples::elastic_statistics({}, 5));
  for (const auto& [name, member] : kMeasuredMembers) EXPECT_FALSE((q.*member).ci95) << name;
  EXPECT_EQ(q.batches, 0);
  EXPECT_NE(q.note.find("window too short for confidence intervals: 5 blocks"), std::string::npos) << q.note;
}

TEST(Derived, UnbalancedStressIsRemarkedUpon) {
  BlockStatistics s = samples::elastic_statistics({}, 10);
  const double wall = s.series["wall_shear_bottom"][0], gradient = s.series["driving_gradient"][0];
  double excess = 0.0;
  samples::add_profile(s, "elastic_stress", Location::kFace, [](double, std::size_t) { return 0.0; });
  samples::add_profile(s, "uv", Location::kFace, [](double, std::size_t) { return 0.0; });
  const auto stress = [&](double y, std::size_t) { return wall * (1.0 + excess) - gradient * y; };
  samples::add_profile(s, "viscous_stress", Location::kFace, stress);
  EXPECT_NEAR(derive(s).stress_balance_residual, 0.0, 1e-12);
  EXPECT_EQ(derive(s).note, "");
  excess = 0.5;
  samples::add_profile(s, "viscous_stress", Location::kFace, stress);
  EXPECT_NEAR(derive(s).stress_balance_residual, 0.5, 1e-12);
  EXPECT_NE(derive(s).note.find("by 50 % of the wall stress"), std::string::npos) << derive(s).note;
}

TEST(Derived, CoarseGridHasNoLogLawAndSaysSo) {
  const DerivedQuantities q = derive(samples::elastic_statistics({}, 10, 12));
  EXPECT_TRUE(std::isnan(q.k_plus_dk.value));
  EXPECT_NE(q.note.find("no log law"), std::string::npos) << q.note;
  EXPECT_NEAR(q.re_tau.value, 240.5, 1e-9);
}

TEST(Derived, AClosedBoxHasAWindowAndNoFriction) {
  BlockStatistics s = samples::elastic_statistics({}, 10);
  s.profiles.clear();
  s.series = {{"kinetic_energy", std::vector<double>(10, 0.01)}};
  s.meanings["kinetic_energy"] = {"rho U_b^2 h^2", "of the box, per depth"};
  const DerivedQuantities q = derive(s);
  EXPECT_EQ(q.blocks, 10);
  EXPECT_TRUE(std::isnan(q.re_tau.value));
  EXPECT_NE(q.note.find("not a channel"), std::string::npos) << q.note;
}

TEST(Derived, RefusesStatisticsThatLackTheEssential) {
  BlockStatistics s = samples::elastic_statistics({}, 10);
  s.series.erase("driving_gradient");
  EXPECT_THROW((void)derive(s), std::runtime_error);
  s = samples::elastic_statistics({}, 10);
  s.profiles.erase("u");
  EXPECT_THROW((void)derive(s), std::runtime_error);
  s = samples::elastic_statistics({}, 10);
  s.profiles["u"].values.pop_back();
  EXPECT_THROW((void)derive(s), std::runtime_error);
  EXPECT_THROW((void)derive(samples::elastic_statistics({}, 0)), std::runtime_error);
}

}  // namespace
}  // namespace softwall::analysis
