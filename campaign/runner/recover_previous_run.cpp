#include <algorithm>
#include <filesystem>
#include <system_error>

#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_directory.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/runner/orphans.hpp"
#include "campaign/runner/runner.hpp"
#include "campaign/store/import_results.hpp"
#include "campaign/store/settled.hpp"
#include "campaign/system/clock.hpp"
#include "solver/run_directory/build_info.hpp"

/// What the runner does before it starts anything.
namespace softwall::campaign {
namespace {

/// Whether the store knows a case to have finished as its files tell: in the same attempt and, where it ended
/// early, for the same reason.
bool store_agrees_with_files(const CaseRecord& known, const Observation& files) {
  return known.state == CaseState::kFinished && files.state == CaseState::kFinished &&
         known.attempts == files.attempts && (!files.early || known.state_reason == files.reason);
}

/// Of a run directory that is away nothing can be derived; one without checkpoints may have its averages.
bool has_averages(const RunFiles& run) {
  std::error_code unreadable;
  return std::filesystem::exists(run.statistics(), unreadable) &&
         std::filesystem::exists(run.summary(), unreadable);
}

}  // namespace

/// Deals with what an earlier runner left: adopts or ends its solvers, and brings the store up to the run
/// directories. False when the user asked to stop meanwhile.
bool Runner::recover_previous_run() {
  const auto& cases = book_.campaign().cases;
  store_.record_campaign(book_.campaign());
  find_settled();
  const bool ready = end_what_is_not_adopted();
  if (!ready) {
    for (const CampaignCase& one : cases) {
      book_.look_at(one);
      if (const auto at = working_.find(one.definition.id); at != working_.end())
        book_.mark_running(one, at->second.presence);
    }
    return false;
  }
  record_what_is_new();
  store_.mark_stale(build_info().version);
  book_.look_at_starting_points();
  const auto origins = store_.result_origins();
  Transaction together(store_.connection());
  for (const CampaignCase& one : cases) {
    const Observation& seen = book_.seen(one);
    const CaseState state = seen.state;
    if (state == CaseState::kInterrupted || state == CaseState::kFailed || state == CaseState::kDiverged)
      import_result_so_far(store_, one, book_.files_of(one), state);
    if (state != CaseState::kFinished) continue;
    if (!seen.needs_person.empty() && !has_averages(book_.files_of(one))) continue;
    const auto origin = origins.find(one.definition.id);
    if (origin == origins.end() || !is_recorded(origin->second, one, book_.files_of(one), seen.time))
      deliver_result(one);
  }
  together.commit();
  return true;
}

/// Finds the cases that are settled: nothing of them has to be opened, asked or written.
void Runner::find_settled() {
  const auto records = store_.all_cases();
  for (const CampaignCase& one : book_.campaign().cases) {
    const CaseRecord& known = records.at(one.definition.id);
    if (is_settled(one, known, book_.files_of(one))) book_.settle(one, known);
  }
}

/// The store is brought up to the run directories. A case that it knows to have finished, in the attempt that
/// the files tell of, needs nothing.
void Runner::record_what_is_new() {
  const auto is_settled = [&](const CampaignCase& one) { return book_.is_settled(one); };
  if (std::ranges::all_of(book_.campaign().cases, is_settled)) return;
  Transaction together(store_.connection());
  const auto before = store_.all_cases();
  std::vector<Observation> seen;
  for (const CampaignCase& one : book_.campaign().cases) {
    const std::string& id = one.definition.id;
    if (is_settled(one)) {
      seen.push_back(book_.seen(one));
      continue;
    }
    const RunFiles run = book_.files_of(one);
    seen.push_back(observe_files(one, run));
    if (seen.back().state == CaseState::kFinished && !working_.contains(id) &&
        restore_case_file(one.definition, run))
      progress_.event(one.definition.label + ": its case.json was lost, and is written again");
    if (working_.contains(id)) continue;
    if (store_agrees_with_files(before.at(id), seen.back())) {
      import_checkpoints(store_, id, run);  // somebody may have removed old ones
      continue;
    }
    import_history(store_, one, run, seen.back());
    store_.forgive(id);  // whoever runs the campaign again asks for another try
  }
  const auto after = store_.all_cases();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const CampaignCase& one = book_.campaign().cases[i];
    if (is_settled(one)) continue;
    book_.look_at(one, seen[i], after.at(one.definition.id));
    if (options_.start_over) book_.forgive_divergence(one);
    if (const auto at = working_.find(one.definition.id); at != working_.end())
      book_.mark_running(one, at->second.presence);
  }
  together.commit();
}

bool Runner::end_what_is_not_adopted() {
  std::vector<WorkPlace> others;
  for (const CampaignCase& one : book_.campaign().cases) {
    if (!book_.is_settled(one) && !adopt(one)) others.push_back({one.definition.label, book_.files_of(one)});
  }
  return end_orphans(others, launcher_, options_.grace, signals_, progress_);
}

/// True when an attempt of an earlier softwall goes on, and is watched from now on like one of our own.
bool Runner::adopt(const CampaignCase& one) {
  const std::string& id = one.definition.id;
  const RunFiles run = book_.files_of(one);
  const auto record = read_run_record(run);
  if (!record || record->case_id != id || store_.attempts(id) > record->attempt) return false;
  const Presence presence = launcher_.presence(run.directory, record->handle);
  if (presence == Presence::kGone) return false;
  const LaunchRequest request{.case_id = id,
                              .run_directory = run.directory,
                              .attempt = record->attempt,
                              .ranks = one.ranks,
                              .wall_seconds = book_.campaign().execution.walltime_seconds};
  if (!launcher_.adopt(request, record->handle)) return false;
  import_running_attempt(store_, one, run, *record);
  working_.try_emplace(id, request, record->handle, monotonic_seconds()).first->second.presence = presence;
  progress_.event(one.definition.label +
                  ": an earlier softwall started it and it goes on; waiting for its end");
  return true;
}

}  // namespace softwall::campaign
