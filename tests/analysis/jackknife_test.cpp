#include "analysis/jackknife.hpp"

#include <gtest/gtest.h>

#include <ostream>

#include "samples.hpp"

namespace softwall::analysis {
namespace {

double weighted_mean(const std::vector<double>& weights, const std::vector<double>& x) {
  double sum = 0.0, total = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += weights[i] * x[i];
    total += weights[i];
  }
  return sum / total;
}

struct Coverage {
  int given = 0, covered = 0;
  [[nodiscard]] double fraction() const { return static_cast<double>(covered) / given; }
};

/// How often the interval of exp(mean of x) holds exp(0), over many independent windows.
Coverage measure_coverage(int blocks, double rho, int windows = 2000) {
  std::mt19937_64 random(2017);
  Coverage coverage;
  const std::vector<double> weights(blocks, 2.0);
  for (int i = 0; i < windows; ++i) {
    const std::vector<double> x = samples::autoregressive(random, blocks, rho);
    const Estimator estimate = [&](const std::vector<double>& w) {
      return std::vector<double>{std::exp(0.1 * weighted_mean(w, x))};
    };
    const Interval interval = jackknife(weights, estimate).front();
    if (!interval.ci95) continue;
    ++coverage.given;
    coverage.covered += std::fabs(estimate(weights).front() - 1.0) <= *interval.ci95;
  }
  return coverage;
}

struct Window {
  int blocks;
  double rho;
  double least_given;
  friend std::ostream& operator<<(std::ostream& out, const Window& window) {
    return out << window.blocks << " blocks, correlation " << window.rho;
  }
};

class JackknifeCoverage : public testing::TestWithParam<Window> {};

TEST_P(JackknifeCoverage, LiesBetween90And98Percent) {
  const Coverage coverage = measure_coverage(GetParam().blocks, GetParam().rho);
  RecordProperty("coverage", std::to_string(coverage.fraction()));
  std::printf("blocks %d, rho %.1f: covered %.3f of the %d given\n", GetParam().blocks, GetParam().rho,
              coverage.fraction(), coverage.given);
  EXPECT_GE(coverage.fraction(), 0.90);
  EXPECT_LE(coverage.fraction(), 0.98);
  EXPECT_GE(coverage.given, GetParam().least_given * 2000);
}

// Windows of ten correlation times or more; correlated neighbours and independent ones, odd counts too.
INSTANTIATE_TEST_SUITE_P(Windows, JackknifeCoverage,
                         testing::Values(Window{8, 0.0, 0.75}, Window{17, 0.0, 0.98}, Window{32, 0.3, 0.98},
                                         Window{40, 0.6, 0.96}, Window{64, 0.0, 0.99}, Window{64, 0.6, 0.98},
                                         Window{150, 0.6, 0.99}, Window{300, 0.3, 0.99},
                                         Window{300, 0.8, 0.99}));

TEST(Jackknife, RefusesTooFewBlocks) {
  const std::vector<double> weights = {1, 1, 1, 1, 1, 1, 1, 0, 0};
  const auto interval =
      jackknife(weights, [](const std::vector<double>&) { return std::vector<double>{1.0}; }).front();
  EXPECT_FALSE(interval.ci95);
  EXPECT_NE(interval.reason.find("7 blocks, 8 needed"), std::string::npos) << interval.reason;
}

TEST(Jackknife, RefusesATrend) {
  std::vector<double> x;
  for (int i = 0; i < 40; ++i) x.push_back(i);
  const std::vector<double> weights(40, 1.0);
  const auto interval = jackknife(weights, [&](const std::vector<double>& w) {
                          return std::vector<double>{weighted_mean(w, x)};
                        }).front();
  EXPECT_FALSE(interval.ci95);
  EXPECT_NE(interval.reason.find("correlated"), std::string::npos) << interval.reason;
}

TEST(Jackknife, KeepsNumbersApart) {
  std::mt19937_64 random(5);
  const std::vector<double> x = samples::autoregressive(random, 64, 0.0);
  const std::vector<double> weights(64, 1.0);
  const auto intervals = jackknife(weights, [&](const std::vector<double>& w) {
    return std::vector<double>{weighted_mean(w, x), std::nan(""), 3.0 * weighted_mean(w, x), 7.0};
  });
  ASSERT_TRUE(intervals[0].ci95 && intervals[2].ci95 && intervals[3].ci95);
  EXPECT_FALSE(intervals[1].ci95);
  EXPECT_NEAR(*intervals[2].ci95, 3.0 * *intervals[0].ci95, 1e-12);
  EXPECT_NEAR(*intervals[3].ci95, 0.0, 1e-12);
}

TEST(Jackknife, ShortLastBlockCountsForItsTimeOnly) {
  // Halving one block's weight must move the interval little; giving it a wild value but almost no weight
  // too.
  std::mt19937_64 random(6);
  std::vector<double> x = samples::autoregressive(random, 33, 0.0);
  std::vector<double> weights(33, 2.0);
  const auto width = [&] {
    return *jackknife(weights,
                      [&](const std::vector<double>& w) { return std::vector<double>{weighted_mean(w, x)}; })
                .front()
                .ci95;
  };
  weights[32] = 0.0;
  const double without = width();
  weights[32] = 1e-9;
  x[32] = 1e3;
  EXPECT_NEAR(width(), without, 0.1 * without);
}

}  // namespace
}  // namespace softwall::analysis
