#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "campaign/launch/launcher.hpp"
#include "campaign/store/store.hpp"

namespace softwall::campaign {

struct ImportedDirectories {
  int results = 0;                    ///< derived now
  std::vector<std::string> troubles;  ///< "G=1: why it has finished and has no result", one a case
};

/// Brings all that the run directories of these cases hold into a store that knows the cases and little or
/// nothing else: attempts, those at work too, checkpoints, states and results. Throws SqliteError.
ImportedDirectories import_directories(Store& store, const std::vector<CampaignCase>& cases,
                                       const std::filesystem::path& folder, const Launcher& launcher);

}  // namespace softwall::campaign
