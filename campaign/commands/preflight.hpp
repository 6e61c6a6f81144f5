#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/commands/campaign_folder.hpp"
#include "campaign/core/plan.hpp"
#include "campaign/launch/launcher.hpp"
#include "campaign/observe/disk.hpp"
#include "solver/case/bad_input.hpp"

/// What must be right before anything is changed. `plan` shows it, `run` refuses to start by it: the same
/// checks in the same words.
namespace softwall::campaign {

struct Preflight {
  std::vector<Mistake> mistakes;     ///< what is in the way; empty: nothing
  std::vector<std::string> blocked;  ///< by case: why it cannot be started here; empty: it can
  std::string no_programs;  ///< why nothing could be started, where nothing is to be; empty: it could
  DiskNeed disk;            ///< what is yet to be written
  double disk_free_bytes = 0.0;
  double memory_bytes = 0.0;  ///< of the cases at work side by side, at most
  double machine_memory_bytes = 0.0;
  int machine_cores = 0;  ///< that softwall may use
};

/// Looks only at what is yet to be started: the cases of a finished campaign need nothing, neither a solver
/// nor mpirun. Prepares the launcher.
[[nodiscard]] Preflight preflight(const LoadedCampaign& loaded, const std::vector<Observation>& observations,
                                  Launcher& launcher);

/// All that is in the way, in the words in which a run is refused.
[[nodiscard]] BadInput refusal(const Preflight& preflight, const std::filesystem::path& folder);

/// Throws it if there is any.
void require_nothing_in_the_way(const Preflight& preflight, const std::filesystem::path& folder);

/// Whether a case is yet to be started, now or after its precursor.
[[nodiscard]] bool may_start(Outlook outlook);

/// A file can be made in the campaign's folder. Throws BadInput.
void require_writable(const std::filesystem::path& folder);

}  // namespace softwall::campaign
