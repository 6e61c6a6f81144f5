#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

/// One launch of the solver for a case: what is known before it, and what it left.
namespace softwall::campaign {

/// Whether an attempt is still there.
enum class Presence {
  kQueued,   ///< accepted, not yet begun
  kRunning,  ///< a process of it is at work
  kGone,     ///< nothing of it is left
  kUnknown   ///< nobody answers at the moment; it must be taken for running
};

/// How an attempt ended.
enum class AttemptOutcome {
  kFinished,       ///< end time reached, summary written
  kInterrupted,    ///< stopped on request or by a time limit, checkpoint written
  kDiverged,       ///< non-finite or runaway field
  kBadCase,        ///< case.json refused
  kBadCheckpoint,  ///< no usable checkpoint
  kIoFailure,      ///< disk full or I/O error
  kTimeout,        ///< ended by the scheduler without an orderly end
  kKilled,         ///< ended by a signal from outside
  kOutOfMemory,
  kNodeFailure,
  kStalled,     ///< made no step for too long and was ended
  kNotStarted,  ///< intended, but no process ever ran
  kLost,        ///< its manager died; how it ended was not seen
  kFailed,      ///< any other error
};

/// What is known before the launch.
struct AttemptStart {
  std::string host;
  int ranks = 0;
  std::string resumed_from;  ///< checkpoint, relative to the run directory; empty: from the initial state
};

/// What an attempt left; unknown members stay empty and become NULL.
struct AttemptEnd {
  AttemptOutcome outcome = AttemptOutcome::kFailed;
  std::string reason;
  std::optional<int> exit_code;               ///< of the launcher, as a shell reports it
  std::optional<std::int64_t> step;           ///< furthest step known to have been reached
  std::optional<double> time;                 ///< its time [h/U_b]
  std::optional<std::int64_t> attempt_steps;  ///< steps made by this attempt
  std::optional<double> wall_seconds;
  std::optional<double> ns_per_cell_step;
  std::string started, ended;  ///< ISO 8601 UTC as the solver wrote it; ended empty: now
  std::string version, git_revision, build_type, compiler;  ///< of softwall-dns
  std::map<std::string, double> diagnostics;                ///< of summary.json, by name
  /// Where it ran and began, by its own word: a job runs on other machines than it was submitted from, and
  /// may begin long after. Empty: as was intended.
  std::optional<AttemptStart> began = std::nullopt;
};

/// An attempt that has ended.
struct PastAttempt {
  int attempt = 0;
  AttemptStart start;
  AttemptEnd end;
};

}  // namespace softwall::campaign
