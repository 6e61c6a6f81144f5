#pragma once

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::time {

/// The state at time 0 of an interface wave: the mode of linear theory (case/interface_mode.hpp) with the
/// rate of the case, its crest at x = 0, where the interface stands the displacement of the case above y = 2.
/// Velocity and what the solid carries are the mode's at the quantity's place, exact to first order in the
/// displacement; a projection then removes the divergence that the grid's own differences leave.
///
/// Over laminar flow (laminar_mean.hpp) the wave moves downstream, and the mean flow follows its
/// displacement, so that the velocity is continuous across the interface. The mode is that of the layers at
/// rest: it resembles the wave that the flow makes of it, and what does not belong to that wave decays.
[[nodiscard]] State interface_wave_at_start(Setup& setup);

}  // namespace softwall::time
