#pragma once

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::time {

/// The fluid and, in an elastic case, the layer of a setup at rest.
[[nodiscard]] State state_at_rest(const Setup& setup);

/// A laminar parabola of bulk velocity 1 with a perturbation that leads to turbulence: pairs of streamwise
/// vortices, which lift up streaks, and solenoidal noise that breaks them (amplitude and seed of the case).
/// The noise is a function of the position of each cell alone, so the field does not depend on the number of
/// ranks.
[[nodiscard]] State perturbed_laminar(Setup& setup);

/// Removes the divergence of the state's velocity (after interpolation or perturbation) and sets its flow
/// rate.
void make_solenoidal(State& state, Setup& setup);

}  // namespace softwall::time
