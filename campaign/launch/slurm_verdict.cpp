#include "campaign/launch/slurm_verdict.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace softwall::campaign {

const QueuedJob* most_alive(const std::vector<QueuedJob>& jobs) {
  const auto rank = [](const QueuedJob& job) {
    constexpr std::array kOrder = {Presence::kRunning, Presence::kQueued, Presence::kUnknown,
                                   Presence::kGone};
    return std::ranges::find(kOrder, presence_in(job.state)) - kOrder.begin();
  };
  const auto found = std::ranges::min_element(jobs, {}, rank);
  return found == jobs.end() ? nullptr : &*found;
}

std::optional<Verdict> verdict_on(const QueuedJob& job) {
  constexpr int kCannotWrite = 128 + 53;  // Slurm shows it as 0:53
  const std::string& state = job.state;
  const std::string name = "its job " + job.number;
  if (state == "TIMEOUT" || state == "DEADLINE")
    return Verdict{AttemptOutcome::kTimeout, name + " reached its time limit"};
  if (state == "CANCELLED") return Verdict{AttemptOutcome::kKilled, name + " was cancelled"};
  if (state == "OUT_OF_MEMORY")
    return Verdict{AttemptOutcome::kOutOfMemory, name + " needed more memory than it had asked for"};
  if (state == "NODE_FAIL" || state == "BOOT_FAIL")
    return Verdict{AttemptOutcome::kNodeFailure, "a node of " + name + " failed"};
  if (state == "PREEMPTED" || state == "REVOKED")
    return Verdict{AttemptOutcome::kNodeFailure, name + " had to make room for another"};
  if (job.exit_code == kCannotWrite)
    return Verdict{AttemptOutcome::kFailed,
                   name + " could not write its log: is the campaign's folder there on the nodes?"};
  if (job.exit_code) return std::nullopt;
  return Verdict{AttemptOutcome::kFailed, name + " ended as " + state};
}

}  // namespace softwall::campaign
