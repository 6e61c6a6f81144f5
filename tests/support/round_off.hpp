#pragma once

#include <limits>

#include "solver/grid/grid.hpp"

namespace softwall::support {

/// What round-off may leave: so many times the relative distance of neighbouring numbers of a field, so that
/// a test asks the same of both precisions.
constexpr double round_off(double times) { return times * std::numeric_limits<grid::Real>::epsilon(); }

}  // namespace softwall::support
