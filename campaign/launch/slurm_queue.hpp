#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "campaign/core/attempt.hpp"

/// What Slurm says about this user's jobs: one question for all of them, kept for a while.
namespace softwall::campaign {

/// A job as squeue or sacct has it.
struct QueuedJob {
  std::string number;
  std::string name;
  std::string state;             ///< Slurm's word, "PENDING", "NODE_FAIL"
  std::string why;               ///< Slurm's reason for that state; may be empty
  std::optional<int> exit_code;  ///< of one that has ended, as a shell shows it
};

/// kGone for a job that has ended, kUnknown for a word that this softwall does not know.
[[nodiscard]] Presence presence_in(std::string_view state);
/// Whether Slurm vouches with this word that no process of the job is left. When a node has failed, nobody
/// knows.
[[nodiscard]] bool leaves_no_process(std::string_view state);

/// Lines of `squeue --Format=JobID:|,State:|,exit_code:|,Reason:|,Name:|`. Empty when anything in them is not
/// of that form: half an answer is none.
[[nodiscard]] std::optional<std::vector<QueuedJob>> parse_squeue(std::string_view text);
/// Lines of `sacct --parsable2 --format=JobIDRaw,State,ExitCode,JobName`, in the same way.
[[nodiscard]] std::optional<std::vector<QueuedJob>> parse_sacct(std::string_view text);

/// How often Slurm is asked, and how long it may take, in seconds.
struct SlurmPace {
  double shortest = 1.0, longest = 30.0;  ///< between two questions; longer while nothing changes
  double longest_silence = 60.0;          ///< between two questions that get no answer
  double answer = 30.0;                   ///< for an answer
  double doubt =
      30.0;  ///< after sbatch was cut off, until a job that is not in the queue has not been accepted
  /// A run directory in which nothing was written for so long is at rest. A network file system may show us a
  /// file a minute late.
  double quiet = 90.0;
  /// So long a job with room for more cases waits for them: those of a job that reaches its time limit end
  /// one after the other, and go on together.
  double gathering = 20.0;
  /// For so long jobs are submitted one after the other before softwall looks at anything else.
  double submitting = 2.0;
};

class SlurmQueue {
 public:
  explicit SlurmQueue(SlurmPace pace) : pace_(pace) {}
  /// Asks if it is time to; else what was heard last holds.
  void refresh();
  /// Something has been changed: ask again soon.
  void hurry();

  /// Whether the last question was answered.
  [[nodiscard]] bool answers() const { return answered_; }
  /// Why it was not, in Slurm's words.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  /// When the question was asked whose answer holds, monotonic seconds.
  [[nodiscard]] double asked_at() const { return asked_at_; }
  /// Every job of this name; of most names there is one.
  [[nodiscard]] const std::vector<QueuedJob>& called(const std::string& name) const;
  /// What the accounting knows about jobs that are no longer in the queue, by name, the newest of each;
  /// nothing where there is no accounting.
  [[nodiscard]] std::unordered_map<std::string, QueuedJob> past(const std::vector<std::string>& names) const;

 private:
  void take(std::vector<QueuedJob> jobs);

  SlurmPace pace_;
  std::unordered_map<std::string, std::vector<QueuedJob>> jobs_;  ///< by name
  std::string text_;  ///< of the last answer, to see whether it changes
  bool answered_ = false;
  std::string trouble_;
  double asked_at_ = -1e9, pause_ = 0.0;
};

}  // namespace softwall::campaign
