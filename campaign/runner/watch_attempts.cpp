#include <algorithm>

#include "campaign/observe/averages.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/runner/runner.hpp"
#include "campaign/store/import_results.hpp"
#include "campaign/system/clock.hpp"

/// What the runner does with attempts while they are at work.
namespace softwall::campaign {
namespace {

/// It has shown for so long already that it makes no step; a checkpoint is not likely to come later.
StopGrace grace_of_a_stalled_one(const RunnerOptions& options) {
  StopGrace grace = options.grace;
  grace.checkpoint_seconds = std::min(grace.checkpoint_seconds, options.stall_seconds);
  return grace;
}

}  // namespace

void Runner::read_reports() {
  const double now = monotonic_seconds();
  for (auto& [id, watch] : working_) {
    const auto status = read_status(book_.files_of(book_.find(id)), id);
    if (status && status->attempt == watch.attempt) watch.report(*status, now);
    if (!watch.begun && (watch.status || solver_is_inside(book_.files_of(book_.find(id)))))
      note_begin(book_.find(id), watch);
  }
}

void Runner::note_begin(const CampaignCase& one, AttemptWatch& watch) {
  watch.begun = true;
  if (!launcher_.attempts_stay()) return;  // it began when it was started
  book_.mark_running(one);
  progress_.event(one.definition.label + ": its job has begun");
}

/// The solver leaves its averages beside every checkpoint: a case can be judged, and its window chosen,
/// before it ends.
void Runner::import_on_the_way() {
  const double now = monotonic_seconds();
  for (auto& [id, watch] : working_) {
    if (!watch.status || watch.status->checkpoint_step <= watch.imported_step) continue;
    if (now - watch.imported_at < options_.import_seconds) continue;
    watch.imported_step = watch.status->checkpoint_step;
    watch.imported_at = now;
    const CampaignCase& one = book_.find(id);
    const RunFiles run = book_.files_of(one);
    import_result_so_far(store_, one, run, CaseState::kRunning);
    if (!watch.end && intervals_are_met(one, run)) end_early(one, watch, now);
  }
}

/// The solver is asked as a user would ask it: it writes a checkpoint and ends in order. Nothing is noted
/// anywhere, because what it leaves then tells by itself that the case is done. If the intervals have grown
/// again by that time, the case goes on to its next checkpoint.
void Runner::end_early(const CampaignCase& one, AttemptWatch& watch, double now) {
  progress_.event(one.definition.label + ": " + describe(one.until) + ", asked to end");
  watch.end.emplace(options_.grace, now);
}

/// Ranks that never leave MPI_Init write nothing and take no request: they are noticed long before a step
/// would be missed. An attempt that waits in a queue, or of which nobody can say whether it runs, is none of
/// them; its time begins when it has left the queue, which is therefore looked for all the while.
void Runner::end_if_stalled(const CampaignCase& one, AttemptWatch& watch, double now) {
  constexpr double kBetweenLooks = 0.05;  // of the shortest of the times that are allowed
  const double shortest = std::min(options_.begin_seconds, options_.stall_seconds);
  const bool may_wait = launcher_.attempts_stay() && watch.is_stalled(now, kBetweenLooks * shortest);
  const bool no_step = watch.is_stalled(now, options_.stall_seconds);
  const bool not_begun = !watch.begun && watch.is_stalled(now, options_.begin_seconds);
  if (!may_wait && !no_step && !not_begun) return;
  const Presence presence = launcher_.presence(book_.files_of(one).directory, watch.handle);
  if (presence == Presence::kQueued || presence == Presence::kUnknown) watch.moved_at = now;
  if (!no_step && !not_begun) return;
  if (presence != Presence::kRunning && !(no_step && presence == Presence::kGone)) return;
  StopGrace grace = grace_of_a_stalled_one(options_);
  if (no_step) {
    watch.why_ended = "made no step for " + describe_duration(options_.stall_seconds);
  } else {
    watch.why_ended =
        "its ranks did not get through MPI_Init in " + describe_duration(options_.begin_seconds);
    grace.checkpoint_seconds = 0;  // there is nothing to write
  }
  progress_.event(one.definition.label + ": " + watch.why_ended + "; ending this attempt",
                  Progress::Kind::kBad);
  watch.end.emplace(grace, now);
  watch.stalled = true;
}

/// Asks what has stalled, or need not go on, to end. Nothing stalls once a person has asked all to end: an
/// attempt that writes a checkpoint makes no step, and pass_on_stop() asks more firmly in its own time.
void Runner::end_what_is_over() {
  const double now = monotonic_seconds();
  for (auto& [id, watch] : working_) {
    const CampaignCase& one = book_.find(id);
    if (!watch.end && signals_.stop_requests() == 0) end_if_stalled(one, watch, now);
    if (!watch.end) continue;
    if (const auto level = watch.end->due(now)) ask_to_end(id, watch, *level);
  }
}

}  // namespace softwall::campaign
