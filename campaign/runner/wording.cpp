#include "campaign/runner/wording.hpp"

#include <algorithm>

#include "campaign/core/words.hpp"
#include "campaign/system/clock.hpp"
#include "solver/case/time_comparison.hpp"

namespace softwall::campaign {
namespace {

std::string place(double time, std::int64_t step) {
  return "t = " + short_number(time) + " (step " + std::to_string(step) + ")";
}

}  // namespace

std::string describe_start(const CampaignCase& one, int ranks, const Ladder& ladder, bool queued) {
  const std::string& label = one.definition.label;
  const std::string goal =
      " to t = " + short_number(one.definition.run.end_time) + ", " + counted(ranks, "rank");
  const std::string begin = queued ? ": submitted" : ": started";
  if (!ladder.newest) return label + begin + goal;
  return label + (queued ? ": submitted, from " : ": resumed from ") +
         place(ladder.header.time, ladder.header.step) + goal;
}

std::string describe_end_of_attempt(const CampaignCase& one, const AttemptEnd& end, const Observation& seen) {
  const std::string& label = one.definition.label;
  if (seen.early) return label + ": " + seen.reason + ", at " + place(seen.time, seen.step);
  const std::string because = end.reason.empty() ? "" : ": " + end.reason;
  switch (end.outcome) {
    case AttemptOutcome::kFinished:
      return label + ": finished at " + place(seen.time, seen.step) +
             (end.wall_seconds ? " after " + describe_duration(*end.wall_seconds) : std::string());
    case AttemptOutcome::kInterrupted:
      return label + ": " + (end.reason.empty() ? "interrupted" : end.reason) + "; safe at " +
             place(seen.time, seen.step);
    case AttemptOutcome::kDiverged:
      return label + ": diverged" + because;
    case AttemptOutcome::kIoFailure:
      return label + ": paused, disk full or I/O error" + because + "; safe at " +
             place(seen.time, seen.step);
    default:
      return label + ": attempt failed" + because + "; safe at " + place(seen.time, seen.step);
  }
}

std::string describe_stop(int asked, std::size_t working) {
  const std::string cases = counted(working, "case");
  if (working == 0) return "stopping";
  if (asked == 1)
    return "stopping: waiting for " + cases + " to write a checkpoint (Ctrl-C again: do not wait)";
  if (asked == 2) return "ending " + cases + " within seconds (Ctrl-C again: at once)";
  return "ending " + cases + " at once";
}

std::string describe_breakdown(const std::string& reason, std::size_t working) {
  return reason + "; waiting for " + counted(working, "case") + " to write a checkpoint";
}

std::string describe_leaving(std::size_t working, std::size_t not_submitted) {
  std::string words = "leaving";
  if (working > 0)
    words += "; " + std::to_string(working) + (working == 1 ? " job goes" : " jobs go") +
             " on without softwall, and the next run waits for " + (working == 1 ? "it" : "them");
  if (not_submitted > 0)
    words += "; " + counted(not_submitted, "case") + " not submitted yet, which the next run does";
  return words;
}

std::string describe_progress(const Campaign& campaign, const std::vector<Observation>& observations,
                              const std::map<std::string, Status>& working, double seconds_left) {
  const auto finished = std::ranges::count_if(
      observations, [](const Observation& seen) { return seen.state == CaseState::kFinished; });
  std::string line = std::to_string(finished) + "/" + std::to_string(campaign.cases.size()) + " finished";
  std::string separator = " | ";
  for (const CampaignCase& one : campaign.cases) {
    const auto status = working.find(one.definition.id);
    if (status == working.end()) continue;
    const double percent = percent_done(status->second.time, one.definition.run.end_time);
    line += separator + one.definition.label + " t=" + short_number(status->second.time) + " " +
            std::to_string(static_cast<int>(percent)) + " %";
    separator = ", ";
  }
  const auto queued = std::ranges::count_if(observations, [](const Observation& seen) {
    return seen.running && seen.presence == Presence::kQueued;
  });
  if (queued > 0) line += " | " + std::to_string(queued) + " queued";
  return seconds_left > 0 ? line + " | " + describe_about(seconds_left) + " left" : line;
}

}  // namespace softwall::campaign
