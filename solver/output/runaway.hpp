#pragma once

#include <string>

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::output {

/// Faster than any flow driven at velocity 1 ever gets, U_b; a run beyond it has diverged.
inline constexpr double kFastestVelocity = 50.0;

/// Whether a velocity may exceed kFastestVelocity, or be no number, for all that a convection rate
/// (fluid/stability.hpp) tells. Asked every step, so that a NaN is caught before it can enter a checkpoint;
/// stresses that are not finite reach the velocity within a substep.
[[nodiscard]] bool may_be_runaway(double convection_rate, const grid::Grid& grid);

/// Largest |velocity component| among this rank's cells, U_b; infinite when one is not a number.
[[nodiscard]] double fastest_here(const grid::VectorField& velocity, const grid::Grid& grid);

/// What is wrong with a velocity that is too fast.
[[nodiscard]] std::string describe_runaway(const time::State& state, double fastest);

}  // namespace softwall::output
