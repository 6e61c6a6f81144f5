#include "campaign/store/import_results.hpp"

#include <algorithm>
#include <stdexcept>

#include "analysis/derived.hpp"
#include "campaign/observe/history.hpp"
#include "campaign/observe/ladder.hpp"
#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_reports.hpp"
#include "solver/run_directory/build_info.hpp"
#include "solver/run_directory/statistics_file.hpp"

namespace softwall::campaign {
namespace {

void close_open_attempts(Store& store, const CampaignCase& one, const RunFiles& run) {
  for (const OpenAttempt& open : store.open_attempts()) {
    if (open.case_id != one.definition.id) continue;
    store.end_attempt(open.case_id, open.attempt, describe_end(one, run, open.attempt, std::nullopt));
  }
}

/// Those that a store which was made again does not know.
void restore_history(Store& store, const CampaignCase& one, const RunFiles& run) {
  const std::string& id = one.definition.id;
  if (store.attempts(id) > 0) return;
  for (const PastAttempt& past : read_history(run, id))
    store.restore_attempt(id, past.attempt, past.start, past.end);
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
  store.restore_attempt(id, newest, start, describe_end(one, run, newest, std::nullopt));
}

/// Another version of the solver may compute other numbers; nothing is computed again unasked.
std::string why_stale(const Summary& summary) {
  const std::string now = build_info().version;
  if (summary.version.empty() || summary.version == now) return "";
  return "computed by version " + summary.version + ", this is " + now;
}

/// The same window, and recorded after the attempt ended: two attempts can end within a second, and a window
/// whose last block has only grown keeps its ends. Deriving again is cheap and harmless. (UTC in the same
/// form, so that the order of the texts is the order in time.)
bool is_current(const ResultOrigin& origin, const analysis::DerivedQuantities& derived,
                const Summary& summary) {
  return origin.analysis_version == analysis::kAnalysisVersion && origin.recorded >= summary.ended &&
         origin.window_start == derived.window_start && origin.window_end == derived.window_end;
}

}  // namespace

void import_history(Store& store, const CampaignCase& one, const RunFiles& run, const Launcher& launcher) {
  const std::string& id = one.definition.id;
  close_open_attempts(store, one, run);
  restore_history(store, one, run);
  restore_newest_attempt(store, one, run);
  store.record_checkpoints(id, checkpoint_records(run));
  const Observation seen = observe(one, run, launcher);
  if (!seen.running) store.set_state(id, seen.state, seen.reason);
}

bool import_result(Store& store, const CampaignCase& one, const RunFiles& run) {
  const std::string& id = one.definition.id;
  const auto summary = read_summary(run, id);
  if (!summary) throw std::runtime_error("there is no summary of this case in " + run.directory.string());
  store.set_stale(id, why_stale(*summary));
  const auto statistics = analysis::read_statistics(run.statistics());
  if (!statistics.case_id.empty() && statistics.case_id != id) {
    throw std::runtime_error(run.statistics().string() + " belongs to another case, " + statistics.case_id);
  }
  const auto derived = analysis::derive(statistics);
  const auto origin = store.result_origin(id);
  if (origin && is_current(*origin, derived, *summary)) return false;
  store.record_result(id, derived, build_info().git_revision);
  return true;
}

Observation with_history(Observation observation, const Store& store) {
  const auto known = store.find_case(observation.case_id);
  if (!known) return observation;
  observation.attempts = std::max(observation.attempts, known->attempts);
  observation.attempts_without_progress = known->attempts_without_progress;
  const bool unfinished =
      observation.state == CaseState::kNew || observation.state == CaseState::kInterrupted;
  const bool store_knows_more = known->state == CaseState::kFailed || known->state == CaseState::kDiverged;
  if (unfinished && store_knows_more) {
    observation.state = known->state;
    observation.reason = known->state_reason;
  }
  return observation;
}

}  // namespace softwall::campaign
