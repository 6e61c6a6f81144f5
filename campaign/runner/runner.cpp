#include "campaign/runner/runner.hpp"

#include <stdexcept>
#include <system_error>
#include <utility>

#include "campaign/core/eta.hpp"
#include "campaign/observe/attempt_end.hpp"
#include "campaign/observe/history.hpp"
#include "campaign/observe/ladder.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_directory.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/runner/wording.hpp"
#include "campaign/store/import_results.hpp"
#include "campaign/system/clock.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {
namespace {

/// "All cores there are" as a number, for the plan too.
Campaign with_counted_cores(Campaign campaign, const Launcher& launcher) {
  campaign.execution.cores = cores_to_use(campaign.execution.cores, launcher);
  return campaign;
}

bool failed_by_itself(AttemptOutcome outcome) {
  return outcome != AttemptOutcome::kFinished && outcome != AttemptOutcome::kInterrupted &&
         outcome != AttemptOutcome::kDiverged;
}

/// Whether it may be our own request that ended an attempt before it had written a checkpoint: it was killed,
/// or its mpirun was terminated, which then leaves with 1 as after any failure. A solver that has left its
/// own word (the time of its end) was not.
bool may_be_ended_on_request(const AttemptEnd& end) {
  const bool without_word = end.outcome == AttemptOutcome::kFailed && end.ended.empty() &&
                            end.exit_code == static_cast<int>(ExitCode::kFailed);
  return end.outcome == AttemptOutcome::kKilled || without_word;
}

}  // namespace

Runner::Runner(Campaign campaign, std::filesystem::path folder, Parts parts, RunnerOptions options)
    : launcher_(parts.launcher),
      store_(parts.store),
      progress_(parts.progress),
      signals_(parts.signals),
      options_(options),
      book_(with_counted_cores(std::move(campaign), parts.launcher), std::move(folder), parts.store,
            parts.progress),
      progress_line_(parts.progress) {
  if (options_.start_over) book_.allow_starting_over();
  store_.connection().wait_for_locks([this] { return wait_for_store(); });
}

Runner::~Runner() {
  store_.connection().wait_for_locks([] { return false; });  // nobody is left to wait
}

RunnerReport Runner::run() {
  try {
    if (!recover_previous_run()) return report();
    while (true) {
      for (const EndedAttempt& ended : launcher_.collect()) record_end(ended);
      for (const std::string& news : launcher_.news()) progress_.event(news, Progress::Kind::kBad);
      if (signals_.stop_requests() == 0) start_as_many_as_fit();
      if (signals_.stop_requests() > 0) {
        if (launcher_.attempts_stay()) return leave();
        pass_on_stop();
      }
      // A case that cannot be started leaves its cores to others, which the next plan finds.
      const bool may_start_more = changed_ && signals_.stop_requests() == 0;
      if (launcher_.idle() && !may_start_more) return report();
      read_reports();
      end_what_is_over();
      import_on_the_way();
      progress_line_.show(book_, working_, monotonic_seconds());
      signals_.wait(poll());
    }
  } catch (const SqliteError& error) {
    const std::string reason =
        (error.may_pass() ? "the results store cannot be written: " : "") + std::string(error.what());
    end_all(reason);
    if (!error.may_pass()) throw;
    return pause_all(reason);
  } catch (const std::system_error& error) {
    end_all(error.what());
    if (!is_trouble_of_disk(error.code())) throw;
    return pause_all(error.what());
  } catch (const std::exception& error) {
    end_all(error.what());
    throw;
  }
}

std::chrono::milliseconds Runner::poll() const {
  return launcher_.attempts_stay() ? options_.patient_poll : options_.poll;
}

/// A history that cannot be written is no reason to stop: the store has it.
void Runner::keep_history(const CampaignCase& one) {
  const std::string& id = one.definition.id;
  try {
    write_history(book_.files_of(one), id, store_.past_attempts(id));
  } catch (const std::system_error& error) {
    progress_.event(one.definition.label + ": " + error.what(), Progress::Kind::kBad);
  }
}

void Runner::start_as_many_as_fit() {
  if (!std::exchange(changed_, false)) return;
  for (const Action& action : plan(book_.campaign(), book_.observations(), free_cores())) {
    signals_.wait(std::chrono::milliseconds(0));
    if (signals_.stop_requests() > 0) return;
    start(action);
  }
}

void Runner::start(const Action& action) {
  const CampaignCase& one = book_.find(action.case_id);
  const RunFiles run = book_.files_of(one);
  Ladder ladder;
  try {
    prepare_run_directory(one.definition, run, action.initial_checkpoint);
    ladder = book_.check(one);
  } catch (const std::system_error& error) {
    return pause(one, error.what());
  } catch (const NotThisCase& error) {
    return pause(one, error.what());
  }
  if (!ladder.unreadable.empty()) return pause(one, ladder.unreadable);
  if (!ladder.newest && !book_.may_start_over() && had_checkpoints(one)) return pause(one, kNoCheckpointLeft);
  launch(one, action, ladder);
}

/// By what is left in its run directory or, where that is gone, by what the store remembers.
bool Runner::had_checkpoints(const CampaignCase& one) const {
  const std::string& id = one.definition.id;
  return checkpoints_are_lost(book_.files_of(one), id) ||
         store_.find_case(id).value_or(CaseRecord{}).had_checkpoints;
}

/// The case is not started again before a person runs the campaign again.
void Runner::pause(const CampaignCase& one, const std::string& reason) {
  changed_ = true;
  book_.pause(one, reason);
  progress_.event(one.definition.label + ": paused: " + reason, Progress::Kind::kBad);
  book_.look_at(one);
}

void Runner::launch(const CampaignCase& one, const Action& action, const Ladder& ladder) {
  const std::string& id = one.definition.id;
  const RunFiles run = book_.files_of(one);
  const std::string from =
      ladder.newest ? ladder.newest->lexically_relative(run.directory).string() : std::string();
  // The intent is on disk before anything is started: no attempt is ever unknown.
  const int attempt = store_.begin_attempt(id, {host_name(), action.ranks, from});
  const std::int64_t first_step = ladder.newest ? ladder.header.step : 0;
  const LaunchRequest request{.case_id = id,
                              .run_directory = run.directory,
                              .attempt = attempt,
                              .ranks = action.ranks,
                              .wall_seconds = book_.campaign().execution.walltime_seconds,
                              .needed_seconds = measured_seconds_left(one, book_.seen(one))};
  const auto note = [&](const Handle& handle) {
    write_run_record(
        run,
        {.case_id = id, .attempt = attempt, .handle = handle, .host = host_name(), .started = utc_now()});
  };
  try {
    if (const Handle intended = launcher_.intended(request); !intended.empty()) note(intended);
    const Handle handle = launcher_.start(request);
    working_.try_emplace(id, request, handle, monotonic_seconds(), first_step);
    note(handle);
    store_.attempt_started(id, attempt, handle);
  } catch (const std::runtime_error& error) {
    if (working_.contains(id)) throw;  // it runs, only its record failed: a matter for end_all()
    AttemptEnd end;
    end.outcome = AttemptOutcome::kNotStarted;
    end.reason = error.what();
    end.step = first_step;
    record_not_started(one, attempt, end);
    return pause(one, end.reason);
  }
  book_.mark_running(one, launcher_.attempts_stay() ? Presence::kQueued : Presence::kRunning);
  progress_.event(describe_start(one, action.ranks, ladder, launcher_.attempts_stay()));
}

/// Nothing of the attempt ever ran.
void Runner::record_not_started(const CampaignCase& one, int attempt, const AttemptEnd& end) {
  store_.end_attempt(one.definition.id, attempt, end);
  keep_history(one);
  store_.set_state(one.definition.id, observe_files(one, book_.files_of(one)).state, end.reason);
}

void Runner::record_end(const EndedAttempt& ended) {
  const CampaignCase& one = book_.find(ended.case_id);
  changed_ = true;
  const AttemptWatch watch = working_.at(ended.case_id);
  working_.erase(ended.case_id);
  const AttemptEnd end = end_of(one, watch, ended);
  Transaction together(
      store_.connection());  // durable at once; what a crash leaves out is found in the files
  store_.end_attempt(ended.case_id, watch.attempt, end);
  keep_history(one);
  record_state(one, end);
  together.commit();
}

/// How an attempt ended, in the light of what was asked of it.
AttemptEnd Runner::end_of(const CampaignCase& one, const AttemptWatch& watch,
                          const EndedAttempt& ended) const {
  AttemptEnd end = describe_end(one, book_.files_of(one), watch.attempt, ended);
  const bool stopping = signals_.stop_requests() > 0;
  const bool without_step = end.outcome == AttemptOutcome::kInterrupted && end.step <= watch.first_step;
  if (watch.stalled && end.outcome != AttemptOutcome::kFinished) {
    end.outcome = AttemptOutcome::kStalled;
    end.reason = watch.why_ended;
  } else if (stopping && may_be_ended_on_request(end)) {
    end.outcome = AttemptOutcome::kInterrupted;
    end.reason = "stopped on request before it had written a checkpoint";
  } else if (without_step && ended.verdict && ended.verdict->outcome == AttemptOutcome::kNodeFailure) {
    end.outcome = AttemptOutcome::kNodeFailure;  // no fault of the case, however early
    end.reason = ended.verdict->reason;
  } else if (!stopping && without_step) {
    end.outcome = AttemptOutcome::kFailed;  // a limit too short for a single step would be retried for ever
    end.reason = "interrupted before its first step (" + end.reason + ")";
  }
  return end;
}

/// The state of a case after an attempt, in the store and for the plan; what a person should know about it.
void Runner::record_state(const CampaignCase& one, const AttemptEnd& end) {
  const std::string& id = one.definition.id;
  const RunFiles run = book_.files_of(one);
  import_checkpoints(store_, id, run);
  const Observation files = observe_files(one, run);
  CaseState state = files.state;
  if (failed_by_itself(end.outcome)) state = CaseState::kFailed;
  if (end.outcome == AttemptOutcome::kDiverged) state = CaseState::kDiverged;
  store_.set_state(id, state, files.early ? files.reason : end.reason);
  if (end.outcome == AttemptOutcome::kIoFailure) book_.pause(one, "disk full or I/O error: " + end.reason);
  if (end.outcome == AttemptOutcome::kBadCase) book_.give_up(one, end.reason);
  book_.look_at(one, files, store_.find_case(id).value_or(CaseRecord{}));
  book_.look_at_starting_point(one);
  const bool is_finished = book_.seen(one).state == CaseState::kFinished;
  progress_.event(describe_end_of_attempt(one, end, book_.seen(one)),
                  is_finished                                   ? Progress::Kind::kGood
                  : end.outcome == AttemptOutcome::kInterrupted ? Progress::Kind::kPlain
                                                                : Progress::Kind::kBad);
  if (is_finished)
    deliver_result(one);
  else
    import_result_so_far(store_, one, run, state);
}

void Runner::deliver_result(const CampaignCase& one) {
  const std::string& id = one.definition.id;
  without_result_.erase(id);
  try {
    import_result(store_, one, book_.files_of(one));
  } catch (const SqliteError&) {
    throw;  // the store itself is in trouble: not a matter of this case
  } catch (const std::runtime_error& error) {
    if (repair_statistics(one, error.what())) return;
    without_result_[id] = std::string("finished, but without a result: ") + error.what();
    if (!options_.no_programs.empty())
      without_result_[id] += "; it cannot be made again: " + options_.no_programs;
    progress_.event(one.definition.label + ": " + without_result_[id], Progress::Kind::kBad);
  }
}

/// Statistics travel in the checkpoint: the solver writes the same file again when it goes on from the last
/// one, which takes no step. Once in a run, because what fails twice is not a matter of the file.
bool Runner::repair_statistics(const CampaignCase& one, const std::string& trouble) {
  const std::string& id = one.definition.id;
  const RunFiles run = book_.files_of(one);
  std::vector<std::filesystem::path> ladder;
  try {
    ladder = checkpoint_ladder(run);
  } catch (const std::system_error&) {
    return false;  // they cannot be read now: no help from there
  }
  if (ladder.empty() || !options_.no_programs.empty() || !statistics_are_damaged(run, id)) return false;
  if (!repaired_.insert(id).second) return false;
  book_.mark_unfinished(one, ladder.front(), "its statistics are made again from its last checkpoint");
  progress_.event(one.definition.label + ": " + trouble + "; made again from its last checkpoint",
                  Progress::Kind::kBad);
  changed_ = true;
  return true;
}

RunnerReport Runner::report() const {
  return make_report(book_, without_result_, signals_.stop_requests() > 0);
}

int Runner::free_cores() const {
  int busy = 0;
  for (const auto& [id, watch] : working_) busy += watch.ranks;
  return book_.campaign().execution.cores - busy;
}

}  // namespace softwall::campaign
