#include "campaign/commands/verify_record.hpp"

#include <cmath>
#include <optional>
#include <tuple>

#include "campaign/observe/attempt_end.hpp"
#include "campaign/observe/run_reports.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/case.hpp"
#include "solver/run_directory/summary.hpp"

namespace softwall::campaign {
namespace {

/// What attempt and summary both hold, to be compared bit by bit.
auto numbers_of(const AttemptEnd& end) {
  return std::tie(end.step, end.time, end.attempt_steps, end.wall_seconds, end.ns_per_cell_step);
}

auto origin_of(const AttemptEnd& end) {
  return std::tie(end.started, end.ended, end.version, end.git_revision, end.build_type, end.compiler);
}

/// NaN is stored as nothing.
bool same_diagnostics(const AttemptEnd& stored, const AttemptEnd& told) {
  for (const auto& [name, value] : told.diagnostics) {
    const auto found = stored.diagnostics.find(name);
    if (std::isfinite(value) && (found == stored.diagnostics.end() || found->second != value)) return false;
  }
  for (const auto& [name, value] : stored.diagnostics)
    if (!told.diagnostics.contains(name)) return false;
  return true;
}

/// case.json is written anew for every attempt.
std::optional<double> end_time_in_case_file(const RunFiles& run) {
  try {
    return read_case(run.case_file()).run.end_time;
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

/// The store holds what mpirun returned: the solver's status only if nobody killed mpirun after the summary.
bool is_of_the_solver(int exit_code, const Summary& summary) {
  return outcome_of(static_cast<ExitCode>(exit_code)) == summary.outcome;
}

}  // namespace

std::string difference_of_attempt(const Store& store, const CampaignCase& one, const RunFiles& run) {
  const std::string& id = one.definition.id;
  const auto summary = read_summary(run, id);
  if (!summary) return "";
  const auto attempts = store.past_attempts(id);
  if (attempts.empty() || attempts.back().attempt != summary->attempt) {
    const bool older = !attempts.empty() && attempts.back().attempt > summary->attempt;
    if (older) return "";  // the newest attempt left no summary
    return "is of attempt " + std::to_string(summary->attempt) +
           ", of whose end the store does not know; softwall run records it";
  }
  const PastAttempt& stored = attempts.back();
  const AttemptEnd told = describe_end(one, run, summary->attempt);
  const bool in_order = stored.end.outcome == told.outcome;
  if (stored.end.outcome == AttemptOutcome::kFinished && summary->outcome != "finished")
    return "tells another outcome than the store";
  if (in_order && stored.end.exit_code && is_of_the_solver(*stored.end.exit_code, *summary) &&
      stored.end.exit_code != summary->exit_code)
    return "tells another exit status than the store";
  const bool wrote_its_last_step = summary->outcome == "finished" || summary->outcome == "interrupted";
  if (in_order && wrote_its_last_step && !summary->checkpoint.empty() &&
      run.directory / summary->checkpoint != run.checkpoint(summary->step))
    return "names another checkpoint than that of its step";
  const bool was_cut_off = !store.open_attempts(id).empty();  // the next one had rewritten case.json already
  if (!was_cut_off && summary->end_time != end_time_in_case_file(run))
    return "tells another end time than case.json";
  if (numbers_of(stored.end) != numbers_of(told)) return "has other numbers than the store";
  if (origin_of(stored.end) != origin_of(told)) return "names another origin than the store";
  if (stored.start.resumed_from != summary->resumed_from)
    return "began from another checkpoint than the store";
  if (in_order && stored.end.reason != told.reason) return "gives another reason than the store";
  if (stored.start.host != summary->host || stored.start.ranks != summary->ranks)
    return "names another host or other ranks than the store";
  return same_diagnostics(stored.end, told) ? "" : "has other diagnostics than the store";
}

std::string trouble_with_no_summary(const Store& store, const std::string& case_id) {
  const auto attempts = store.past_attempts(case_id);
  if (attempts.empty()) return "";
  return attempts.back().end.outcome == AttemptOutcome::kFinished
             ? "is missing; the last attempt had ended with one"
             : "";
}

}  // namespace softwall::campaign
