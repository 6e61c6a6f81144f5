#pragma once

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::time {

/// The state at time 0 of a closed box: fluid, and a disc where the case has one, at rest; or, where the
/// velocity is prescribed, a rigid rotation about the middle of the box, one turn a unit of time,
///   u = -2 pi (y - height / 2),   v = 2 pi (x - length_x / 2),   0 through the walls.
[[nodiscard]] State closed_box_at_start(Setup& setup);

}  // namespace softwall::time
