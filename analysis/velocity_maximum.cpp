#include "analysis/velocity_maximum.hpp"

#include <algorithm>

namespace softwall::analysis {

VelocityMaximum velocity_maximum(const std::vector<double>& y, const std::vector<double>& u) {
  const auto top = static_cast<std::size_t>(std::max_element(u.begin(), u.end()) - u.begin());
  if (top == 0 || top + 1 == u.size()) return {u[top], y[top]};
  const double left = (u[top] - u[top - 1]) / (y[top] - y[top - 1]);    // slope below the point
  const double right = (u[top + 1] - u[top]) / (y[top + 1] - y[top]);   // slope above it
  const double curvature = (right - left) / (y[top + 1] - y[top - 1]);  // Newton's second divided difference
  if (!(curvature < 0.0)) return {u[top], y[top]};
  // u(y) = u_top + slope (y - y_top) + curvature (y - y_top)^2
  const double slope = left + curvature * (y[top] - y[top - 1]);
  const double shift = -slope / (2.0 * curvature);
  return {u[top] + 0.5 * slope * shift, y[top] + shift};
}

}  // namespace softwall::analysis
