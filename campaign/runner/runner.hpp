#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "campaign/core/campaign.hpp"
#include "campaign/core/plan.hpp"
#include "campaign/launch/launcher.hpp"
#include "campaign/runner/attempt_watch.hpp"
#include "campaign/runner/case_book.hpp"
#include "campaign/runner/progress.hpp"
#include "campaign/runner/progress_line.hpp"
#include "campaign/runner/runner_report.hpp"
#include "campaign/store/store.hpp"
#include "campaign/system/signals.hpp"

namespace softwall::campaign {

struct RunnerOptions {
  double stall_seconds =
      1800.0;  ///< an attempt without a new step for this long is ended; much longer than a step
  /// An attempt whose ranks run but do not get through MPI_Init for this long is ended.
  double begin_seconds = 180.0;
  StopGrace grace;
  double import_seconds = 5.0;          ///< of a case at work, results are not recorded more often than this
  std::chrono::milliseconds poll{200};  ///< between two looks at attempts that end with softwall
  /// And at those that go on without it: a look at each of them is a few questions to a network's file
  /// system.
  std::chrono::milliseconds patient_poll{2000};
  std::string no_programs;      ///< why nothing can be started; empty: it can
  bool start_over = false;      ///< cases may start from the beginning although they had checkpoints
  double store_seconds = 10.0;  ///< how long a locked store is waited for once the user has asked to stop
};

/// Runs a campaign to its end: decides by plan(), starts by the launcher, records in the store.
/// The caller holds the campaign's lock.
class Runner {
 public:
  struct Parts {
    Launcher& launcher;
    Store& store;
    Progress& progress;
    Signals& signals;
  };

  Runner(Campaign campaign, std::filesystem::path folder, Parts parts, RunnerOptions options);
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Returns when nothing more can be done or the user asked to stop, and no solver is left; those that stay
  /// with their launcher are left at work when the user asks. When the manager itself fails, it lets every
  /// other solver write a checkpoint before the exception leaves.
  RunnerReport run();

 private:
  bool recover_previous_run();
  void find_settled();
  [[nodiscard]] bool end_what_is_not_adopted();
  void record_what_is_new();
  [[nodiscard]] bool adopt(const CampaignCase& one);
  void start_as_many_as_fit();
  void start(const Action& action);
  [[nodiscard]] bool had_checkpoints(const CampaignCase& one) const;
  void pause(const CampaignCase& one, const std::string& reason);
  void launch(const CampaignCase& one, const Action& action, const Ladder& ladder);
  void record_not_started(const CampaignCase& one, int attempt, const AttemptEnd& end);
  [[nodiscard]] AttemptEnd end_of(const CampaignCase& one, const AttemptWatch& watch,
                                  const EndedAttempt& ended) const;
  void record_end(const EndedAttempt& ended);
  void record_state(const CampaignCase& one, const AttemptEnd& end);
  void deliver_result(const CampaignCase& one);
  [[nodiscard]] bool repair_statistics(const CampaignCase& one, const std::string& trouble);
  void read_reports();
  void note_begin(const CampaignCase& one, AttemptWatch& watch);
  void end_if_stalled(const CampaignCase& one, AttemptWatch& watch, double now);
  void end_early(const CampaignCase& one, AttemptWatch& watch, double now);
  void end_what_is_over();
  void import_on_the_way();
  void ask_to_end(const std::string& case_id, const AttemptWatch& watch, StopLevel level);
  void pass_on_stop();
  void end_all(const std::string& reason);
  [[nodiscard]] std::size_t take_back_unsubmitted();
  [[nodiscard]] RunnerReport leave();
  [[nodiscard]] RunnerReport pause_all(const std::string& reason);
  [[nodiscard]] bool wait_for_store();
  void keep_history(const CampaignCase& one);
  [[nodiscard]] std::chrono::milliseconds poll() const;
  [[nodiscard]] RunnerReport report() const;
  [[nodiscard]] int free_cores() const;

  Launcher& launcher_;
  Store& store_;
  Progress& progress_;
  Signals& signals_;
  RunnerOptions options_;

  CaseBook book_;
  std::map<std::string, AttemptWatch> working_;        ///< by case id
  std::map<std::string, std::string> without_result_;  ///< finished, but its result could not be derived
  int stop_passed_on_ = 0;
  std::optional<StopLadder> stop_;  ///< set when the user has asked to stop
  std::set<std::string> repaired_;  ///< finished cases whose statistics are made again in this run
  bool changed_ = true;             ///< something has happened since the plan was last made
  ProgressLine progress_line_;
  double locked_since_ = 0.0;     ///< monotonic seconds when another program's lock was first in the way
  double locked_seen_at_ = -1e9;  ///< and when it was last
};

}  // namespace softwall::campaign
