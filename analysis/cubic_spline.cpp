#include "analysis/cubic_spline.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace softwall::analysis {

CubicSpline::CubicSpline(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), second_(x_.size(), 0.0) {
  const std::size_t n = x_.size();
  if (n < 3 || y_.size() != n) throw std::invalid_argument("a spline needs three points or more");
  // Continuity of the slope at the inner knots, second derivative 0 at the ends: tridiagonal, solved by
  // Thomas.
  std::vector<double> upper(n, 0.0), right(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double below = x_[i] - x_[i - 1], above = x_[i + 1] - x_[i];
    if (!(below > 0.0) || !(above > 0.0)) throw std::invalid_argument("spline knots must increase");
    const double jump = (y_[i + 1] - y_[i]) / above - (y_[i] - y_[i - 1]) / below;
    const double pivot = 2.0 * (below + above) - below * upper[i - 1];
    upper[i] = above / pivot;
    right[i] = (6.0 * jump - below * right[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) second_[i] = right[i] - upper[i] * second_[i + 1];
}

std::size_t CubicSpline::interval(double at) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, at);
  return static_cast<std::size_t>(above - x_.begin()) - 1;
}

double CubicSpline::value(double at) const {
  const std::size_t i = interval(at);
  const double h = x_[i + 1] - x_[i], b = (at - x_[i]) / h, a = 1.0 - b;
  return a * y_[i] + b * y_[i + 1] +
         ((a * a * a - a) * second_[i] + (b * b * b - b) * second_[i + 1]) * h * h / 6.0;
}

double CubicSpline::slope(double at) const {
  const std::size_t i = interval(at);
  const double h = x_[i + 1] - x_[i], b = (at - x_[i]) / h, a = 1.0 - b;
  return (y_[i + 1] - y_[i]) / h +
         ((3.0 * b * b - 1.0) * second_[i + 1] - (3.0 * a * a - 1.0) * second_[i]) * h / 6.0;
}

}  // namespace softwall::analysis
