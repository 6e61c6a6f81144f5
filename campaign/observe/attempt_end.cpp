#include "campaign/observe/attempt_end.hpp"

#include <csignal>

#include "campaign/observe/observe.hpp"
#include "campaign/observe/run_reports.hpp"
#include "solver/run_directory/exit_codes.hpp"

namespace softwall::campaign {
namespace {

struct Meaning {
  AttemptOutcome outcome;
  const char* text;
};

/// What an exit status means when the solver left no record of its end.
Meaning meaning_of(int exit_code) {
  switch (exit_code) {
    case static_cast<int>(ExitCode::kIoFailure):
      return {AttemptOutcome::kIoFailure, "solver.log says where"};
    case static_cast<int>(ExitCode::kDiverged):
      return {AttemptOutcome::kDiverged, "the solution diverged"};
    case static_cast<int>(ExitCode::kCheckpointRefused):
      return {AttemptOutcome::kBadCheckpoint, "no checkpoint could be used"};
    case static_cast<int>(ExitCode::kBadCase):
      return {AttemptOutcome::kBadCase, "the solver refused case.json"};
    case static_cast<int>(ExitCode::kInterrupted):
      return {AttemptOutcome::kInterrupted, "stopped on request"};
    case 128 + SIGKILL:
      return {AttemptOutcome::kKilled, "killed from outside, or out of memory (SIGKILL)"};
    case 128 + SIGTERM:
      return {AttemptOutcome::kKilled, "ended from outside (SIGTERM)"};
    case 128 + SIGUSR1:
      return {AttemptOutcome::kKilled, "stopped before it was ready to write a checkpoint"};
    case 128 + SIGSEGV:
      return {AttemptOutcome::kFailed, "the solver crashed (SIGSEGV)"};
    case 128 + SIGABRT:
      return {AttemptOutcome::kFailed, "the solver crashed (SIGABRT)"};
    case 128 + SIGFPE:
      return {AttemptOutcome::kFailed, "the solver crashed (SIGFPE)"};
    case 128 + SIGXFSZ:
      return {AttemptOutcome::kIoFailure, "a file would exceed the limit of the shell (ulimit -f)"};
    case 128 + SIGILL:  // what mpirun returns for a program it cannot execute
      return {AttemptOutcome::kFailed,
              "the solver could not be executed, or was built for another processor"};
    case 0:
      return {AttemptOutcome::kFailed, "the solver ended without a summary"};
    default:
      return {AttemptOutcome::kFailed, "the solver failed"};
  }
}

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

}  // namespace

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
    const Meaning known = meaning_of(*exit_code);
    end.outcome = known.outcome;
    end.reason = std::string(known.text) + " (exit status " + std::to_string(*exit_code) + ")";
  } else {
    end.outcome = AttemptOutcome::kLost;
    end.reason = "ended while no softwall watched it";
  }
  if (exit_code) end.exit_code = exit_code;
  if (!end.step) {
    const Observation left = observe_files(campaign_case, run);
    end.step = left.step;
    end.time = left.time;
  }
  return end;
}

}  // namespace softwall::campaign
