#pragma once

#include <filesystem>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "campaign/launch/launcher.hpp"

namespace softwall::campaign {

/// A campaign and the folder it lives in.
struct LoadedCampaign {
  Campaign campaign;  ///< "all cores there are" as a number
  std::filesystem::path folder;
  std::filesystem::path named;  ///< absolute; what means this campaign on a command line: its folder, or the
                                ///< campaign file where that is not campaign.json
  std::filesystem::path file;   ///< absolute
};

/// The campaign file that a path means: itself or, where it is a folder, the campaign.json there.
[[nodiscard]] std::filesystem::path campaign_file(const std::filesystem::path& path);

/// From a campaign file, or from a folder with a campaign.json. Throws BadInput.
[[nodiscard]] LoadedCampaign load_campaign(const std::filesystem::path& path);

/// What the run directories say, together with what only the store knows about attempts that failed.
[[nodiscard]] std::vector<Observation> observe_with_history(const LoadedCampaign& loaded,
                                                            const Launcher& launcher);

/// The observations as a run sees them: whoever runs a campaign asks for another try of what has failed and,
/// with `start_over`, of what has lost its checkpoints.
[[nodiscard]] std::vector<Observation> observe_for_run(const LoadedCampaign& loaded, const Launcher& launcher,
                                                       bool start_over = false);

/// The folder that a path means, with a results store in it. Throws BadInput when there is none.
[[nodiscard]] std::filesystem::path folder_with_store(const std::filesystem::path& path);

}  // namespace softwall::campaign
