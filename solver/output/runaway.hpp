#pragma once

#include <string>

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::output {

/// Faster than any channel flow at bulk velocity 1 ever gets; a run beyond it has diverged.
inline constexpr double kFastestVelocity = 50.0;  // U_b

/// Largest |velocity component| among this rank's cells, U_b; infinite when one is not a number. Cheap enough
/// for every step: a NaN is caught before it can enter a checkpoint, and stresses that are not finite reach
/// the velocity within a substep.
[[nodiscard]] double fastest_here(const grid::VectorField& velocity, const grid::Grid& grid);

/// What is wrong with a velocity that exceeds kFastestVelocity.
[[nodiscard]] std::string describe_runaway(const time::State& state, double fastest);

}  // namespace softwall::output
