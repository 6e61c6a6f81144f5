#include "campaign/store/import_results.hpp"

#include <algorithm>
#include <stdexcept>

#include "analysis/derived.hpp"
#include "campaign/observe/attempt_end.hpp"
#include "campaign/observe/averages.hpp"
#include "campaign/observe/history.hpp"
#include "campaign/observe/ladder.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/system/file_system.hpp"
#include "solver/run_directory/build_info.hpp"
#include "solver/run_directory/statistics_file.hpp"

namespace softwall::campaign {
namespace {

/// A manager that was killed between the two has left the end of an attempt in history.json, and not in the
/// store. It had seen that end, which nobody can describe as well afterwards.
void close_open_attempts(Store& store, const CampaignCase& one, const RunFiles& run) {
  const auto open = store.open_attempts(one.definition.id);
  if (open.empty()) return;
  const auto told = read_history(run, one.definition.id);
  for (const OpenAttempt& each : open) {
    const auto known = std::ranges::find(told, each.attempt, &PastAttempt::attempt);
    store.end_attempt(each.case_id, each.attempt,
                      known != told.end() ? known->end : describe_end(one, run, each.attempt));
  }
}

/// Writes the attempts of history.json that the store does not know: it was lost, or a backup took its place.
void restore_history(Store& store, const CampaignCase& one, const RunFiles& run) {
  const std::string& id = one.definition.id;
  const auto known = store.past_attempts(id);
  for (const PastAttempt& past : read_history(run, id)) {
    if (std::ranges::find(known, past.attempt, &PastAttempt::attempt) == known.end())
      store.restore_attempt(id, past.attempt, past.start, past.end);
  }
}

/// The newest attempt in a run directory that the store does not know: the store was lost.
void restore_newest_attempt(Store& store, const CampaignCase& one, const RunFiles& run) {
  const std::string& id = one.definition.id;
  const auto record = read_run_record(run);
  const auto summary = read_summary(run, id);
  const int newest = std::max(record ? record->attempt : 0, summary ? summary->attempt : 0);
  if (newest <= store.attempts(id)) return;
  AttemptStart start;
  if (summary && summary->attempt == newest) {
    start = {summary->host, summary->ranks, summary->resumed_from};
  } else {
    start = {record->host, one.ranks, ""};
  }
  store.restore_attempt(id, newest, start, describe_end(one, run, newest));
}

/// A run directory that is gone, or empty, tells nothing about a case that has come far, or has diverged.
void record_state(Store& store, const std::string& case_id, const Observation& seen) {
  const auto known = store.find_case(case_id);
  const bool has_a_past = known && (known->had_checkpoints || known->state == CaseState::kDiverged);
  if (seen.state != CaseState::kNew || !has_a_past)
    store.set_state(case_id, seen.state, seen.reason);
  else if (known->state == CaseState::kRunning)
    store.set_state(case_id, CaseState::kInterrupted, kNoCheckpointLeft);
}

bool is_same_window(const ResultOrigin& origin, const analysis::DerivedQuantities& derived) {
  return origin.analysis_version == analysis::kAnalysisVersion &&
         origin.window_asked == derived.window_asked && origin.window_start == derived.window_start &&
         origin.window_end == derived.window_end;
}

/// The result is current when it has the same window and was recorded after the attempt ended. The window
/// alone does not tell: one whose last block has only grown keeps its ends. (Both times are UTC in one form,
/// so that they compare as texts. Earlier versions wrote no fractions of a second; at worst such a result is
/// derived once more, which is cheap and harmless.)
bool is_current(const ResultOrigin& origin, const analysis::DerivedQuantities& derived,
                const Summary& summary) {
  return is_same_window(origin, derived) && origin.recorded >= summary.ended;
}

/// Records a result unless the store has one of which `is_same` says that it is the same. True when it was
/// recorded now.
template <class IsSame>
bool record_if_new(Store& store, const std::string& case_id, const analysis::DerivedQuantities& derived,
                   const IsSame& is_same) {
  const auto origin = store.result_origin(case_id);
  if (origin && is_same(*origin)) return false;
  store.record_result(case_id, derived, build_info().git_revision);
  return true;
}

/// Of a case that has no average yet in the window wanted now.
void remove_result_of_another_window(Store& store, const CampaignCase& one) {
  const auto origin = store.result_origin(one.definition.id);
  if (origin && origin->window_asked != one.window_start) store.remove_result(one.definition.id);
}

}  // namespace

void import_checkpoints(Store& store, const std::string& case_id, const RunFiles& run) {
  std::vector<CheckpointRecord> records;
  try {
    records = checkpoint_records(run);
  } catch (const std::system_error&) {
    return;  // the case itself tells why it cannot go on (observe_files)
  }
  store.record_checkpoints(case_id, records);
}

void import_history(Store& store, const CampaignCase& one, const RunFiles& run, const Observation& seen) {
  const std::string& id = one.definition.id;
  close_open_attempts(store, one, run);
  restore_history(store, one, run);
  restore_newest_attempt(store, one, run);
  import_checkpoints(store, id, run);
  record_state(store, id, seen);
}

void import_running_attempt(Store& store, const CampaignCase& one, const RunFiles& run,
                            const RunRecord& record) {
  const std::string& id = one.definition.id;
  if (store.attempts(id) >= record.attempt)
    return store.set_state(id, CaseState::kRunning, "attempt " + std::to_string(record.attempt));
  restore_history(store, one, run);
  store.restore_open_attempt(id, record.attempt, {record.host, one.ranks, ""}, record.handle);
}

bool import_result(Store& store, const CampaignCase& one, const RunFiles& run) {
  const std::string& id = one.definition.id;
  const auto summary = read_summary(run, id);
  if (!summary) throw std::runtime_error("there is no summary of this case in " + run.directory.string());
  const auto statistics = analysis::read_statistics(run.statistics());
  if (!statistics.case_id.empty() && statistics.case_id != id) {
    throw std::runtime_error(run.statistics().string() + " belongs to another case, " + statistics.case_id);
  }
  const auto derived = analysis::derive(statistics, window_from(one.window_start));
  return record_if_new(store, id, derived,
                       [&](const ResultOrigin& origin) { return is_current(origin, derived, *summary); });
}

bool import_result_so_far(Store& store, const CampaignCase& one, const RunFiles& run, CaseState state) {
  const std::string& id = one.definition.id;
  if (state == CaseState::kDiverged) {
    store.remove_result(id);
    return false;
  }
  const auto derived = averages_so_far(one, run);
  if (!derived) remove_result_of_another_window(store, one);
  return derived && record_if_new(store, id, *derived, [&](const ResultOrigin& origin) {
           return is_same_window(origin, *derived);
         });
}

bool is_recorded(const ResultOrigin& origin, const CampaignCase& one, const RunFiles& run,
                 double reached_time) {
  if (origin.analysis_version != analysis::kAnalysisVersion || origin.window_asked != one.window_start)
    return false;
  if (origin.window_end < reached_time - one.definition.physics.statistics.block_length) return false;
  for (const auto& file : {run.statistics(), run.summary()}) {
    const std::string changed = change_time(file);
    if (changed.empty() || changed >= origin.recorded) return false;
  }
  return true;
}

bool statistics_are_damaged(const RunFiles& run, const std::string& case_id) {
  try {
    const auto statistics = analysis::read_statistics(run.statistics());
    return !statistics.case_id.empty() && statistics.case_id != case_id;
  } catch (const std::runtime_error&) {
    return true;
  }
}

Observation with_history(Observation observation, const CaseRecord& known) {
  observation.attempts = std::max(observation.attempts, known.attempts);
  observation.attempts_without_progress = known.attempts_without_progress;
  const bool unfinished =
      observation.state == CaseState::kNew || observation.state == CaseState::kInterrupted;
  const bool store_knows_more = known.state == CaseState::kFailed || known.state == CaseState::kDiverged;
  if (unfinished && store_knows_more) {
    observation.state = known.state;
    observation.reason = known.state_reason;
  }
  // A disk that is not mounted, or a run directory that somebody has cleared.
  const bool is_over = observation.state == CaseState::kFinished || observation.state == CaseState::kDiverged;
  const bool has_none = !observation.newest_checkpoint && observation.needs_person.empty();
  if (known.had_checkpoints && !is_over && has_none) {
    observation.needs_person = kNoCheckpointLeft;
    if (observation.state == CaseState::kNew && known.state == CaseState::kFinished) {
      observation.state = CaseState::kFinished;  // its results are there, and nobody need compute it again
      observation.step = known.reached_step;
      observation.time = known.reached_time;
    }
  }
  return observation;
}

}  // namespace softwall::campaign
