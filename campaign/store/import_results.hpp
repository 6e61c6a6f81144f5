#pragma once

#include <string>

#include "campaign/core/campaign.hpp"
#include "campaign/launch/launcher.hpp"
#include "campaign/store/store.hpp"
#include "solver/run_directory/run_files.hpp"

/// From run directories into the store. Every function may be repeated at any time: it leaves the same rows.
namespace softwall::campaign {

/// What the store has not yet of the attempts and checkpoints in a run directory that nobody works in: the
/// ends of attempts whose runner died, and, in a store made anew, the newest attempt itself.
void import_history(Store& store, const CampaignCase& campaign_case, const RunFiles& run,
                    const Launcher& launcher);

/// The result of a finished case, unless the store has it already from this version of the analysis and from
/// this run. True when it was derived now. Throws std::runtime_error when the statistics cannot be used.
bool import_result(Store& store, const CampaignCase& campaign_case, const RunFiles& run);

/// An observation completed by what only the store knows: failures and ends without a summary.
[[nodiscard]] Observation with_history(Observation observation, const Store& store);

}  // namespace softwall::campaign
