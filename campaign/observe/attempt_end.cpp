#include "campaign/observe/attempt_end.hpp"

#include <algorithm>
#include <array>
#include <csignal>

#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_reports.hpp"
#include "solver/run_directory/exit_codes.hpp"

namespace softwall::campaign {
namespace {

constexpr ExitMeaning meaning(ExitCode code, AttemptOutcome outcome, const char* text) {
  return {static_cast<int>(code), outcome, text};
}

/// As a shell, and mpirun, report a program that a signal has ended.
constexpr ExitMeaning meaning_of_signal(int signal, AttemptOutcome outcome, const char* text) {
  return {128 + signal, outcome, text};
}

constexpr std::array kMeanings = {
    meaning(ExitCode::kDone, AttemptOutcome::kFailed, "the solver ended without a summary"),
    meaning(ExitCode::kIoFailure, AttemptOutcome::kIoFailure, "solver.log says where"),
    meaning(ExitCode::kDiverged, AttemptOutcome::kDiverged, "the solution diverged"),
    meaning(ExitCode::kCheckpointRefused, AttemptOutcome::kBadCheckpoint, "no checkpoint could be used"),
    meaning(ExitCode::kBadCase, AttemptOutcome::kBadCase, "the solver refused case.json"),
    meaning(ExitCode::kInterrupted, AttemptOutcome::kInterrupted, "stopped on request"),
    meaning_of_signal(SIGKILL, AttemptOutcome::kKilled, "killed from outside, or out of memory (SIGKILL)"),
    meaning_of_signal(SIGTERM, AttemptOutcome::kKilled, "ended from outside (SIGTERM)"),
    meaning_of_signal(SIGUSR1, AttemptOutcome::kKilled, "stopped before it was ready to write a checkpoint"),
    meaning_of_signal(SIGSEGV, AttemptOutcome::kFailed, "the solver crashed (SIGSEGV)"),
    meaning_of_signal(SIGABRT, AttemptOutcome::kFailed, "the solver crashed (SIGABRT)"),
    meaning_of_signal(SIGFPE, AttemptOutcome::kFailed, "the solver crashed (SIGFPE)"),
    meaning_of_signal(SIGXFSZ, AttemptOutcome::kIoFailure,
                      "a file would exceed the limit of the shell (ulimit -f)"),
    // What mpirun returns for a program that it cannot execute.
    meaning_of_signal(SIGILL, AttemptOutcome::kFailed,
                      "the solver could not be executed, or was built for another processor"),
};

AttemptOutcome outcome_in(const Summary& summary, const CampaignCase& campaign_case) {
  if (is_finished(summary, campaign_case)) return AttemptOutcome::kFinished;
  if (summary.outcome == "interrupted" || summary.outcome == "finished") return AttemptOutcome::kInterrupted;
  if (summary.outcome == "diverged") return AttemptOutcome::kDiverged;
  return summary.exit_code ? meaning_of(*summary.exit_code).outcome : AttemptOutcome::kFailed;
}

AttemptEnd end_from_summary(const Summary& summary, const CampaignCase& campaign_case) {
  AttemptEnd end;
  end.outcome = outcome_in(summary, campaign_case);
  end.reason = summary.reason;
  end.exit_code = summary.exit_code;
  end.step = summary.step;
  end.time = summary.time;
  end.attempt_steps = summary.attempt_steps;
  end.wall_seconds = summary.wall_seconds;
  end.ns_per_cell_step = summary.ns_per_cell_step;
  end.started = summary.started;
  end.ended = summary.ended;
  end.version = summary.version;
  end.git_revision = summary.git_revision;
  end.build_type = summary.build_type;
  end.compiler = summary.compiler;
  end.diagnostics = summary.diagnostics;
  if (!summary.host.empty() && summary.ranks > 0)
    end.began = AttemptStart{summary.host, summary.ranks, summary.resumed_from};
  return end;
}

/// What an attempt that left no summary had taken when it last told its progress, about a second before its
/// end.
std::optional<double> wall_seconds_told(const RunFiles& run, const std::string& case_id, int attempt) {
  const auto status = read_status(run, case_id);
  if (!status || status->attempt != attempt || status->wall_seconds <= 0) return std::nullopt;
  return status->wall_seconds;
}

}  // namespace

ExitMeaning meaning_of(int exit_code) {
  const auto* const known = std::ranges::find(kMeanings, exit_code, &ExitMeaning::exit_code);
  if (known != kMeanings.end()) return *known;
  return {exit_code, AttemptOutcome::kFailed, "the solver failed"};
}

AttemptEnd describe_end(const CampaignCase& campaign_case, const RunFiles& run, int attempt,
                        const EndedAttempt& seen) {
  const auto& exit_code = seen.exit_code;
  const std::string& id = campaign_case.definition.id;
  AttemptEnd end;
  if (const auto summary = read_summary(run, id); summary && summary->attempt == attempt) {
    end = end_from_summary(*summary, campaign_case);
  } else if (seen.verdict) {
    end.outcome = seen.verdict->outcome;
    end.reason = seen.verdict->reason;
  } else if (exit_code) {
    const ExitMeaning known = meaning_of(*exit_code);
    end.outcome = known.outcome;
    end.reason = std::string(known.text) + " (exit status " + std::to_string(*exit_code) + ")";
  } else {
    end.outcome = AttemptOutcome::kLost;
    end.reason = "ended while no softwall watched it";
  }
  if (!end.wall_seconds) end.wall_seconds = wall_seconds_told(run, id, attempt);
  if (exit_code) end.exit_code = exit_code;
  if (!end.step) {
    const Observation left = observe_files(campaign_case, run);
    end.step = left.step;
    end.time = left.time;
  }
  return end;
}

}  // namespace softwall::campaign
