#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"

/// What to do next, decided from what is wanted and what is there. Pure: no clock, no disk, no processes.
namespace softwall::campaign {

/// What would become of a case if the campaign were run now.
enum class Outlook {
  kStart,    ///< can start from its initial state
  kResume,   ///< can go on from its newest checkpoint
  kRunning,  ///< a solver is at work on it
  kKept,     ///< finished: nothing to do
  kWaiting,  ///< for the case that it starts from
  kBlocked   ///< will not be run again without a user: diverged, bad, failing without progress, too large
};

struct Decision {
  std::string case_id;
  Outlook outlook = Outlook::kStart;
  std::string reason;  ///< human-readable; never empty
};

/// Start or resume this case now.
struct Action {
  std::string case_id;
  int ranks = 1;
  /// The newest valid checkpoint of the case that it starts from, as observed, to be written into
  /// run.initial_checkpoint; empty when the case needs none.
  std::filesystem::path initial_checkpoint;
};

/// One decision a case, in the campaign's order. A case without an observation counts as new.
[[nodiscard]] std::vector<Decision> decide(const Campaign& campaign,
                                           const std::vector<Observation>& observations);

/// The startable cases, in the campaign's order, that fit into the free cores together.
[[nodiscard]] std::vector<Action> plan(const Campaign& campaign, const std::vector<Observation>& observations,
                                       int cores_free);

[[nodiscard]] std::string to_string(Outlook outlook);

}  // namespace softwall::campaign
