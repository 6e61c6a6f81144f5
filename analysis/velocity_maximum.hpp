#pragma once

#include <vector>

namespace softwall::analysis {

struct VelocityMaximum {
  double u = 0.0;  ///< [units of u]
  double y = 0.0;  ///< [units of y], from the bottom wall
};

/// Top of the parabola through the largest value and its two neighbours (spacing may vary). At an end of the
/// data, or where values are not finite, the largest value itself. `y` and `u` are equally long and not
/// empty.
[[nodiscard]] VelocityMaximum velocity_maximum(const std::vector<double>& y, const std::vector<double>& u);

}  // namespace softwall::analysis
