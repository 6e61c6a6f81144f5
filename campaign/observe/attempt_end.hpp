#pragma once

#include "campaign/core/attempt.hpp"
#include "campaign/core/campaign.hpp"
#include "campaign/launch/launcher.hpp"
#include "solver/run_directory/run_files.hpp"

/// How an attempt ended, by what it left or else by what was seen of it. Only reads.
namespace softwall::campaign {

/// What an exit status means when the solver left no record of its end.
struct ExitMeaning {
  int exit_code;  ///< of the launcher, as a shell reports it
  AttemptOutcome outcome;
  const char* text;  ///< for people
};
/// Of any exit status; one that is not known means that the solver failed.
[[nodiscard]] ExitMeaning meaning_of(int exit_code);

/// Why and how an attempt ended that no process works on any more. seen: what its launcher saw of the end;
/// empty when nobody was there to see it.
[[nodiscard]] AttemptEnd describe_end(const CampaignCase& campaign_case, const RunFiles& run, int attempt,
                                      const EndedAttempt& seen = {});

}  // namespace softwall::campaign
