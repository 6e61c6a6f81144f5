#include <gtest/gtest.h>

#include <cmath>

#include "analysis/cubic_spline.hpp"
#include "analysis/velocity_maximum.hpp"

namespace softwall::analysis {
namespace {

std::vector<double> stretched_points(int n) {
  std::vector<double> x;
  for (int i = 0; i < n; ++i)
    x.push_back(1.0 + std::tanh(2.0 * (2.0 * (i + 0.5) / n - 1.0)) / std::tanh(2.0));
  return x;
}

double slope_error(int n) {
  const std::vector<double> x = stretched_points(n);
  std::vector<double> y;
  for (const double at : x) y.push_back(std::log(at + 0.5));
  const CubicSpline spline(x, y);
  double worst = 0.0;
  for (double at = 0.6; at < 1.4; at += 0.01) {
    worst = std::fmax(worst, std::fabs(spline.slope(at) - 1.0 / (at + 0.5)));
  }
  return worst;
}

TEST(CubicSpline, PassesThroughItsPoints) {
  const std::vector<double> x = {0.0, 1.0, 1.5, 4.0}, y = {1.0, -2.0, 0.5, 3.0};
  const CubicSpline spline(x, y);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(spline.value(x[i]), y[i], 1e-14);
}

TEST(CubicSpline, IsExactForAStraightLine) {
  const CubicSpline spline({0.0, 0.1, 1.0, 3.0, 3.5}, {1.0, 1.2, 3.0, 7.0, 8.0});
  for (const double at : {0.05, 0.7, 2.0, 3.4}) {
    EXPECT_NEAR(spline.value(at), 1.0 + 2.0 * at, 1e-13);
    EXPECT_NEAR(spline.slope(at), 2.0, 1e-13);
  }
}

TEST(CubicSpline, SlopeConvergesAtThirdOrder) {
  const double order = std::log2(slope_error(40) / slope_error(80));
  EXPECT_GT(order, 2.7);
}

TEST(CubicSpline, RefusesUselessPoints) {
  EXPECT_THROW(CubicSpline({0.0, 1.0}, {0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(CubicSpline({0.0, 1.0, 1.0}, {0.0, 1.0, 2.0}), std::invalid_argument);
}

TEST(VelocityMaximum, IsExactForAParabolaOnAnyGrid) {
  const std::vector<double> y = stretched_points(23);
  for (const double top : {0.61, 0.8, 1.0}) {
    std::vector<double> u;
    for (const double at : y) u.push_back(1.3 - 0.7 * (at - top) * (at - top));
    const VelocityMaximum found = velocity_maximum(y, u);
    EXPECT_NEAR(found.y, top, 1e-12);
    EXPECT_NEAR(found.u, 1.3, 1e-14);
  }
}

TEST(VelocityMaximum, FindsNoParabolaAtAnEnd) {
  const VelocityMaximum found = velocity_maximum({0.0, 1.0, 2.0}, {1.0, 2.0, 3.0});
  EXPECT_EQ(found.y, 2.0);
  EXPECT_EQ(found.u, 3.0);
}

}  // namespace
}  // namespace softwall::analysis
