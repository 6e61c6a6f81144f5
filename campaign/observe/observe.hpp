#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "campaign/launch/launcher.hpp"
#include "campaign/observe/case_directories.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/run_directory/status.hpp"
#include "solver/run_directory/summary.hpp"

/// What the run directories say. Only reads.
namespace softwall::campaign {

/// The run directory of a case in the campaign's folder, absolute.
[[nodiscard]] RunFiles run_files(const std::filesystem::path& folder, const CampaignCase& campaign_case);

/// Success is the solver's own end record, of this case, at or past the end time; nothing else proves it.
[[nodiscard]] bool is_finished(const Summary& summary, const CampaignCase& campaign_case);

/// One answer a run directory, after one look at all of them: of the attempt there as its launcher sees it,
/// or running while anybody holds the solver's lock.
[[nodiscard]] std::vector<Presence> presences(const std::vector<RunFiles>& runs, const Launcher& launcher);
/// True where an attempt is not gone.
[[nodiscard]] std::vector<bool> occupied(const std::vector<RunFiles>& runs, const Launcher& launcher);
[[nodiscard]] bool is_occupied(const RunFiles& run, const Launcher& launcher);

/// Whether a solver has come as far as to hold the lock of the run directory: through MPI_Init and the case
/// file.
[[nodiscard]] bool solver_is_inside(const RunFiles& run);

/// The state of one case as if nobody worked on it. Checkpoints are looked at by their headers only, and
/// not at all where the case has finished and no other starts from it.
/// `attempts` is the newest attempt that left a trace; counting failures is the store's business.
[[nodiscard]] Observation observe_files(const CampaignCase& campaign_case, const RunFiles& run);

/// It has yet to take its start from the checkpoint of another case, where it takes one.
[[nodiscard]] bool has_yet_to_start(const Observation& seen);

/// The observation of a case of which nothing that is there counts any more.
[[nodiscard]] Observation from_the_beginning(Observation observation);
/// The observation of a case that a person lets start over: lost checkpoints no longer stand in its way. One
/// that has finished needs none.
[[nodiscard]] Observation without_lost_checkpoints(Observation observation);
/// The same of one that has diverged, once a person has removed its checkpoints.
[[nodiscard]] Observation without_divergence(Observation observation);

/// What the solver at work in a run directory has reported; nothing where none works there, or its attempt
/// has yet to report and what stands there is of an earlier one.
[[nodiscard]] std::optional<Status> report_of_work(const RunFiles& run, const Observation& seen);

/// The state of one case.
[[nodiscard]] Observation observe(const CampaignCase& campaign_case, const RunFiles& run,
                                  const Launcher& launcher);

/// The states of these, after one look at the processes of the machine.
[[nodiscard]] std::vector<Observation> observe_all(const std::vector<const CampaignCase*>& cases,
                                                   const std::filesystem::path& folder,
                                                   const Launcher& launcher);

/// Labels are for people, ids are identity: a case that has a directory keeps it, and the label it was run
/// under, however the sweep names it now. `existing`: what existing_directories(folder) found.
void keep_existing_directories(Campaign& campaign, const std::filesystem::path& folder,
                               const CaseDirectories& existing);

}  // namespace softwall::campaign
