#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "campaign/runner/runner.hpp"
#include "campaign/runner/wording.hpp"
#include "campaign/system/clock.hpp"

/// How the runner stops: attempts asked to end, attempts that are left at work, and a campaign that cannot go
/// on.
namespace softwall::campaign {

void Runner::ask_to_end(const std::string& case_id, const AttemptWatch& watch, StopLevel level) {
  launcher_.stop(book_.files_of(book_.find(case_id)).directory, watch.handle, level);
}

/// First request: checkpoint and end. Second: end within seconds. Third: end now. What does not obey is asked
/// more firmly as time passes, also without a second request: a rank may hang.
void Runner::pass_on_stop() {
  const int asked = std::min(signals_.stop_requests(), 3);
  const double now = monotonic_seconds();
  if (!stop_) stop_.emplace(options_.grace, now);
  if (asked > std::exchange(stop_passed_on_, asked)) progress_.event(describe_stop(asked, working_.size()));
  const auto level = stop_->due(now, level_of_requests(asked));
  if (!level) return;
  for (const auto& [id, watch] : working_) ask_to_end(id, watch, *level);
}

/// The manager cannot go on: it says why, and every solver checkpoints and ends; a user who asks more firmly
/// is heard. Those that need no manager are left alone.
void Runner::end_all(const std::string& reason) {
  if (launcher_.attempts_stay() || launcher_.idle()) return;
  progress_.event(describe_breakdown(reason, working_.size()), Progress::Kind::kBad);
  while (!launcher_.idle()) {
    pass_on_stop();
    signals_.wait(options_.poll);
    for (const EndedAttempt& ended : launcher_.collect()) working_.erase(ended.case_id);
  }
}

/// What waits here to be submitted would wait for ever: it is as if it had not been started.
std::size_t Runner::take_back_unsubmitted() {
  const std::vector<std::string> ids = launcher_.take_back();
  if (ids.empty()) return 0;
  Transaction together(store_.connection());
  for (const std::string& id : ids) {
    const CampaignCase& one = book_.find(id);
    const AttemptWatch watch = working_.at(id);
    working_.erase(id);
    AttemptEnd end;
    end.outcome = AttemptOutcome::kNotStarted;
    end.reason = "softwall was left before it was submitted";
    end.step = watch.first_step;
    record_not_started(one, watch.attempt, end);
    book_.look_at(one);
  }
  together.commit();
  return ids.size();
}

/// Jobs of a batch system need no softwall to go on; whoever leaves for the night does not want them ended.
RunnerReport Runner::leave() {
  const std::size_t not_submitted = take_back_unsubmitted();
  for (const auto& [id, watch] : working_) {
    const CampaignCase& one = book_.find(id);
    book_.mark_running(one, launcher_.presence(book_.files_of(one).directory, watch.handle));
  }
  progress_.event(describe_leaving(working_.size(), not_submitted));
  return report();
}

/// Nothing is lost: the run directories are the truth, and the next run records from them.
RunnerReport Runner::pause_all(const std::string& reason) {
  progress_.event("paused: " + reason, Progress::Kind::kBad);
  book_.pause_unfinished("paused: " + reason);
  return report();
}

/// Another program holds the store: the solvers go on meanwhile, and what has to be recorded waits. False
/// when the user has asked to stop and has waited long enough, or asks again although nothing else is waited
/// for; the run directories hold what was not recorded.
bool Runner::wait_for_store() {
  constexpr double kPauseSeconds = 5.0;  // a longer time without a lock ends the matter
  const double now = monotonic_seconds();
  if (now - locked_seen_at_ > kPauseSeconds) {
    locked_since_ = now;
    progress_.event("another program holds results.db; waiting for it, the solvers go on",
                    Progress::Kind::kBad);
  }
  locked_seen_at_ = now;
  const int requests = signals_.stop_requests();
  const bool stay = launcher_.attempts_stay();
  if (requests == 0) locked_since_ = now;
  if (requests > 0 && !stay) pass_on_stop();
  if ((requests > 1 && stay) || now - locked_since_ > options_.store_seconds) return false;
  signals_.wait(options_.poll);
  return true;
}

}  // namespace softwall::campaign
