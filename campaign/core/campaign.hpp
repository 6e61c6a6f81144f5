#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/core/attempt.hpp"
#include "campaign/core/start_order.hpp"
#include "campaign/core/until.hpp"
#include "solver/case/case.hpp"

/// The words of the manager. Campaign: what is wanted. Observation: what is there.
namespace softwall::campaign {

/// What every job of a campaign asks of Slurm. What is empty is the cluster's default.
struct SlurmOptions {
  std::string account, partition;
  std::optional<int> time_limit_minutes;
  std::optional<int> nodes;
  int cases_per_job = 1;                   ///< at most so many cases share a job, on one node
  int signal_seconds = 0;                  ///< Slurm asks for a checkpoint so long before the time limit
  std::string start_with;                  ///< "mpirun" or "srun"
  std::vector<std::string> start_options;  ///< words that follow it
  std::vector<std::string> options;        ///< of sbatch, "--name" or "--name=value"
};

/// Where and how cases are run; changes no number computed.
struct Execution {
  std::string launcher;                    ///< "local" or "slurm"
  int ranks = 1;                           ///< MPI ranks of an elastic case
  int precursor_ranks = 1;                 ///< MPI ranks of a precursor
  int cores = 0;                           ///< cores to use at once; 0: all of the machine
  std::optional<double> walltime_seconds;  ///< of one attempt, which then checkpoints and is resumed
  int max_failures_without_progress = 2;   ///< attempts in a row that add no checkpointed step
  SlurmOptions slurm;                      ///< for the launcher "slurm"
};

/// One point of the sweep, or a precursor.
struct CampaignCase {
  Case definition;
  std::string directory;  ///< "cases/<label>-<first 8 of id>", relative to the campaign's folder
  bool is_precursor = false;
  std::string precursor_id;    ///< case whose last checkpoint starts this one; empty: starts by itself
  bool starts_others = false;  ///< other cases of the campaign start from its last checkpoint
  int ranks = 1;
  std::string varied = "{}";  ///< what differs among the cases of its kind, with its own values, JSON
  double window_start = 0.0;  ///< its averages begin with the first block that starts at or after this, h/U_b
  std::vector<IntervalTarget> until;  ///< it ends before its end time once these are met; empty: it does not
};

struct Campaign {
  std::string name;
  std::string description;
  std::vector<CampaignCase> cases;      ///< precursors first
  std::vector<IntervalTarget> until;    ///< of all cases but precursors
  std::optional<StartFrom> start_from;  ///< cases of the sweep start from others of it
  Execution execution;
  std::string spec_text;  ///< the campaign file as it was read
};

enum class CaseState {
  kNew,          ///< nothing has been computed
  kRunning,      ///< a solver is at work on it
  kFinished,     ///< the solver said so, and the end time is reached
  kInterrupted,  ///< stopped in order, or by its machine, before the end: resume
  kDiverged,     ///< never run again unchanged
  kFailed        ///< ended by an error: retry, bounded
};

/// What the files of a run directory say about a case.
struct Observation {
  std::string case_id;
  CaseState state = CaseState::kNew;
  std::string reason;     ///< why the last attempt ended, human-readable
  std::int64_t step = 0;  ///< furthest step that is safe in a checkpoint or summary
  double time = 0.0;      ///< its time, h/U_b
  double end_time = 0.0;  ///< asked for, h/U_b
  bool early = false;     ///< it has finished before that, because its intervals are small enough
  bool running = false;
  Presence presence = Presence::kGone;                     ///< of the attempt that makes it count as running
  std::optional<std::filesystem::path> newest_checkpoint;  ///< newest one that is valid
  int attempts = 0;
  int attempts_without_progress = 0;  ///< the last ones in a row that added no step
  /// What a user has to see to before it may run again: checkpoints that cannot be read just now, or of
  /// which none is left although there have been some. Empty: nothing.
  std::string needs_person;
  bool retry_allowed = true;      ///< false: the solver said that trying again cannot help (bad case)
  double seconds_per_step = 0.0;  ///< wall clock, measured; 0: not known
  int measured_ranks = 0;         ///< on which that was measured; 0: those of the case
};

}  // namespace softwall::campaign
