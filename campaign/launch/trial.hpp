#pragma once

#include <string>

#include "campaign/launch/launcher.hpp"

namespace softwall::campaign {

/// Starts an attempt of that many ranks, by a launcher whose solver is a program that prints its arguments,
/// so that one sees that it was started. Why this does not work, in the words of what it started; empty when
/// it does. Waits a minute at most.
[[nodiscard]] std::string trouble_with_launch(Launcher& launcher, int ranks);

}  // namespace softwall::campaign
