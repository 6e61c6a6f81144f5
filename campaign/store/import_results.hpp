#pragma once

#include <string>

#include "campaign/core/campaign.hpp"
#include "campaign/store/store.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/run_directory/run_record.hpp"

/// Brings what run directories hold into the store. Every function may be repeated at any time: it leaves the
/// same rows.
namespace softwall::campaign {

/// Records the attempts and checkpoints of a run directory that the store does not know yet: the ends of
/// attempts whose runner died, and, in a store made anew, the attempts themselves. Nobody may work there.
/// seen: what the files of the directory say.
void import_history(Store& store, const CampaignCase& campaign_case, const RunFiles& run,
                    const Observation& seen);

/// Records the attempt that works in a run directory, or is queued for it, and those before it, if the store
/// does not know it: it was lost, or a backup took its place.
void import_running_attempt(Store& store, const CampaignCase& campaign_case, const RunFiles& run,
                            const RunRecord& record);

/// Records the checkpoints of a run directory. Where they cannot be read, the store keeps what it knows.
void import_checkpoints(Store& store, const std::string& case_id, const RunFiles& run);

/// The result of a finished case, unless the store has it already from this version of the analysis and from
/// this run. True when it was derived now. Throws std::runtime_error when the statistics cannot be used.
bool import_result(Store& store, const CampaignCase& campaign_case, const RunFiles& run);

/// The averages so far of a case that has not finished, unless the store has them already. False where there
/// are none yet, or none that can be used; averages over another window than the one wanted are then removed,
/// and so are those of a flow that diverged. Throws SqliteError.
bool import_result_so_far(Store& store, const CampaignCase& campaign_case, const RunFiles& run,
                          CaseState state);

/// True where nothing can have changed since the result was recorded, so that import_result() need not read
/// the statistics. Asks the file system alone. reached_time: of the finished case, h/U_b; a result that ends
/// a block or more before it is one of those recorded on the way, whatever the clock said then.
[[nodiscard]] bool is_recorded(const ResultOrigin& origin, const CampaignCase& campaign_case,
                               const RunFiles& run, double reached_time);

/// Whether statistics.h5 of a case cannot be used: missing, damaged, or of another case.
[[nodiscard]] bool statistics_are_damaged(const RunFiles& run, const std::string& case_id);

/// An observation completed by what only the store knows: failures, ends without a summary, and checkpoints
/// that are gone.
[[nodiscard]] Observation with_history(Observation observation, const CaseRecord& known);

}  // namespace softwall::campaign
