#pragma once

#include <vector>

namespace softwall::analysis {

/// Natural cubic spline through (x, y). The derivative is third-order accurate inside; the error of the
/// natural ends falls by a factor of about four with each point away from them.
class CubicSpline {
 public:
  /// `x` strictly increasing, at least three points. Throws std::invalid_argument otherwise.
  CubicSpline(std::vector<double> x, std::vector<double> y);
  [[nodiscard]] double value(double at) const;
  [[nodiscard]] double slope(double at) const;

 private:
  [[nodiscard]] std::size_t interval(double at) const;
  std::vector<double> x_, y_, second_;  // knots, values, second derivatives
};

}  // namespace softwall::analysis
