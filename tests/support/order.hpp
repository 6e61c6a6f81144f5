#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/support/worse.hpp"

namespace softwall::support {

/// Order of convergence seen between two errors when the spacing falls by `ratio`.
inline double observed_order(double coarse_error, double fine_error, double ratio = 2) {
  return std::log(coarse_error / fine_error) / std::log(ratio);
}

/// The order seen between the last two of several errors.
inline double last_order(const std::vector<double>& errors, double ratio = 2) {
  return observed_order(errors[errors.size() - 2], errors.back(), ratio);
}

/// Order in time without an exact solution, from solutions with dt, dt/2 and dt/4 (Richardson).
inline double richardson_order(const std::vector<double>& coarse, const std::vector<double>& middle,
                               const std::vector<double>& fine) {
  double first = 0, second = 0;
  for (std::size_t n = 0; n < fine.size(); ++n) {
    first = worse(first, std::abs(coarse[n] - middle[n]));
    second = worse(second, std::abs(middle[n] - fine[n]));
  }
  return observed_order(first, second);
}

}  // namespace softwall::support
