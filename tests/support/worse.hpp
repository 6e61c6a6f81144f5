#pragma once

#include <cmath>

#include "solver/parallel/reduce.hpp"

namespace softwall::support {

/// The larger of two errors, where a NaN is the largest of all. (std::fmax would lose it, and with it the
/// test.)
inline double worse(double a, double b) { return std::isnan(a) || a >= b ? a : b; }

/// The largest over all ranks, infinite if one has a NaN.
inline double worst(const parallel::Communicator& comm, double error) {
  return parallel::maximum(comm, std::isnan(error) ? HUGE_VAL : error);
}

}  // namespace softwall::support
