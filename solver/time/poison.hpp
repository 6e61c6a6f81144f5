#pragma once

#include "solver/grid/field.hpp"

/// Debugging: marks ghost cells that are stale, so that a kernel that reads one makes the whole field NaN
/// within a step instead of a small error. CODE.md says what is stale when.
namespace softwall::time {

#ifdef NDEBUG
inline constexpr bool kPoisonsGhosts = false;
#else
inline constexpr bool kPoisonsGhosts = true;
#endif

/// After the prediction: all ghost cells of a velocity but those on the walls in y, which hold v = 0.
void poison_ghosts(grid::VectorField& velocity);

/// Ghost cells of the pressure that no gradient reads: beyond high x, high z and the walls in y.
void poison_unread_ghosts(grid::Field& pressure);

}  // namespace softwall::time
