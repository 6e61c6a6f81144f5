#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "campaign/launch/launcher.hpp"
#include "campaign/store/store.hpp"
#include "solver/run_directory/run_files.hpp"

/// A settled case has finished, the store knows it, and nothing in its run directory was made, changed or
/// removed since the store was last brought up to it: no file of it needs to be opened, and nobody can work
/// there. Precursors never are: others start from their checkpoints.
namespace softwall::campaign {

/// Asks the file system for the times of the run directory, its checkpoints and the files that tell of its
/// end.
[[nodiscard]] bool is_settled(const CampaignCase& campaign_case, const CaseRecord& known,
                              const RunFiles& run);

/// The observation that its files would give, made from the store alone.
[[nodiscard]] Observation settled_observation(const CampaignCase& campaign_case, const CaseRecord& known);

using CaseRecords = std::unordered_map<std::string, CaseRecord>;  ///< by id, as Store::all_cases()

/// All cases of a campaign: the settled ones from the store, the others from their run directories, completed
/// by what only the store knows.
[[nodiscard]] std::vector<Observation> observe_with_records(const Campaign& campaign,
                                                            const std::filesystem::path& folder,
                                                            const Launcher& launcher,
                                                            const CaseRecords& records);

}  // namespace softwall::campaign
