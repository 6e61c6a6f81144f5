#pragma once

#include <string>
#include <vector>

#include "campaign/launch/launcher.hpp"
#include "campaign/runner/progress.hpp"
#include "campaign/runner/stop_ladder.hpp"
#include "campaign/system/signals.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {

/// A run directory in which an earlier softwall may have left a solver.
struct WorkPlace {
  std::string label;  ///< of the case
  RunFiles run;
};

/// Solvers that an earlier softwall left at work (it was killed): asks each to write a checkpoint and end,
/// more firmly as time passes, and waits until no process is left; then removes their temporary files.
/// Afterwards no solver works in any of the places. False when the user asked to stop meanwhile: the first
/// request asks for what has been asked already, further ones make it firmer, and nobody waits for what
/// cannot be reached. Throws std::runtime_error for a solver that cannot be reached from here: of another
/// user or host.
bool end_orphans(const std::vector<WorkPlace>& places, Launcher& launcher, StopGrace grace, Signals& signals,
                 Progress& progress);

}  // namespace softwall::campaign
