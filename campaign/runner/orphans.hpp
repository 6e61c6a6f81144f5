#pragma once

#include <filesystem>

#include "campaign/core/campaign.hpp"
#include "campaign/runner/progress.hpp"
#include "campaign/runner/stop_ladder.hpp"
#include "campaign/system/signals.hpp"

namespace softwall::campaign {

/// Solvers that an earlier softwall left at work (it was killed): ask each to write a checkpoint and end,
/// more firmly as time passes, and wait until no process is left; then remove their temporary files.
/// Afterwards no solver works in any run directory of the campaign. False when the user asked to stop
/// meanwhile. Throws std::runtime_error for a solver that cannot be reached from here: of another user or
/// host.
bool end_orphans(const Campaign& campaign, const std::filesystem::path& folder, StopGrace grace,
                 Signals& signals, Progress& progress);

}  // namespace softwall::campaign
