#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "campaign/core/attempt.hpp"
#include "campaign/core/campaign.hpp"
#include "campaign/observe/ladder.hpp"
#include "solver/run_directory/status.hpp"

/// What the runner says to users.
namespace softwall::campaign {

/// "G=0.5_mu=1: resumed from t = 12.3 (step 1230), 2 ranks". queued: it has yet to wait for its turn.
[[nodiscard]] std::string describe_start(const CampaignCase& one, int ranks, const Ladder& ladder,
                                         bool queued = false);
[[nodiscard]] std::string describe_end_of_attempt(const CampaignCase& one, const AttemptEnd& end,
                                                  const Observation& seen);
/// asked: how often the user has asked to stop.
[[nodiscard]] std::string describe_stop(int asked, std::size_t working);
/// Why the manager cannot go on, and what it waits for.
[[nodiscard]] std::string describe_breakdown(const std::string& reason, std::size_t working);
/// Of so many attempts that go on by themselves, and so many that were not yet with the batch system.
[[nodiscard]] std::string describe_leaving(std::size_t working, std::size_t not_submitted);
/// "2/7 finished | G=1_mu=1 46 %, G=2_mu=1 12 % | about 3 min left"
[[nodiscard]] std::string describe_progress(const Campaign& campaign,
                                            const std::vector<Observation>& observations,
                                            const std::map<std::string, Status>& working,
                                            double seconds_left);

}  // namespace softwall::campaign
