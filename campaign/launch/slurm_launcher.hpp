#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/launch/job_place.hpp"
#include "campaign/launch/launcher.hpp"
#include "campaign/launch/rest_watch.hpp"
#include "campaign/launch/slurm_job.hpp"
#include "campaign/launch/slurm_queue.hpp"

namespace softwall::campaign {

/// Hands attempts to Slurm, one job each, or several to a job where the campaign asks for that. Jobs are
/// found again by their names, which hold campaign, case and attempt, so that nothing is lost, or submitted
/// twice, when an answer is not heard or softwall is killed.
///
/// What Slurm does not say is unknown, asked again later, and never taken for an end. "Not in the queue" does
/// not mean that nobody works either: the solver's own lock and files in the run directory count besides
/// (rest_watch.hpp). A job that Slurm does not take is no failure of its case; it is submitted again later.
///
/// Only a job that works in the run directory is ever asked to end (job_place.hpp): one of a folder of which
/// this is a copy is not adopted, and one of a folder that was moved is waited for.
class SlurmLauncher final : public Launcher {
 public:
  explicit SlurmLauncher(SlurmOptions options, SlurmPace pace = {});

  /// Lets Slurm check a job of so many ranks without submitting it. Throws BadInput in Slurm's words.
  void prepare(const std::filesystem::path& solver, int ranks) override;
  [[nodiscard]] Handle intended(const LaunchRequest& request) const override;
  [[nodiscard]] Handle start(const LaunchRequest& request) override;
  [[nodiscard]] bool adopt(const LaunchRequest& request, const Handle& handle) override;
  [[nodiscard]] bool attempts_stay() const override { return true; }
  [[nodiscard]] std::vector<std::string> take_back() override;
  [[nodiscard]] std::vector<std::string> news() override;
  std::vector<EndedAttempt> collect() override;
  [[nodiscard]] bool idle() const override { return jobs_.empty(); }
  [[nodiscard]] std::vector<Presence> presences(const std::vector<AttemptPlace>& places) const override;
  void stop(const std::filesystem::path& run_directory, const Handle& handle, StopLevel level) override;
  void clean_up(const std::filesystem::path& run_directory) override;
  [[nodiscard]] std::optional<int> job_minutes(const LaunchRequest& request) const override {
    return time_limit(request, options_);
  }
  [[nodiscard]] std::optional<int> capacity() const override { return std::nullopt; }

 private:
  enum class Stage {
    kWaiting,   ///< to be submitted
    kDoubtful,  ///< sbatch was asked, and it is not known whether the job was accepted
    kAccepted
  };
  struct Job {
    LaunchRequest request;
    JobRecord record;
    std::string name;  ///< of the job of Slurm that carries it; empty: none so far, or not known
    Stage stage = Stage::kWaiting;
    JobPlace place = JobPlace::kHere;
    double since = 0.0;        ///< monotonic; it was given to us
    double doubt_until = 0.0;  ///< monotonic; before that its absence from the queue proves nothing
  };
  using Group = std::vector<Job*>;  ///< attempts that one job carries

  [[nodiscard]] std::vector<Group> groups_to_submit(bool also_small_ones);
  /// Whether so many ranks more may share a job, and its one node, with a group.
  [[nodiscard]] bool has_room(const Group& group, int ranks) const;
  [[nodiscard]] bool may_grow(const Group& group) const;
  void submit_waiting(bool also_small_ones);
  [[nodiscard]] static std::vector<LaunchRequest> requests_of(const Group& group);
  void write_scripts(const Group& group) const;
  void submit(const Group& group);
  void resolve_doubt(Job& job);
  void cancel_extra(const std::vector<QueuedJob>& jobs);
  void tell_why_it_waits(const std::string& directory, const std::vector<QueuedJob>& jobs);
  void tell(const std::string& about, const std::string& what);
  [[nodiscard]] Presence presence_of(const Job& job) const;
  [[nodiscard]] Presence presence_of_another(const std::filesystem::path& run_directory,
                                             const JobRecord& record) const;
  [[nodiscard]] bool is_over(const Job& job);
  [[nodiscard]] std::vector<EndedAttempt> ends_of(const std::vector<Job>& over) const;

  SlurmOptions options_;
  SlurmPace pace_;
  JobPrograms programs_;
  std::optional<long> cores_of_a_node_;          ///< of the largest; empty: not known
  mutable SlurmQueue queue_;                     ///< asking does not change the launcher
  mutable RestWatch rest_;                       ///< nor does watching
  std::map<std::string, Job> jobs_;              ///< that were started or adopted and have not ended, by name
  double submit_at_ = 0.0, submit_pause_ = 0.0;  ///< monotonic; sbatch is not asked before
  std::map<std::string, std::string> told_;      ///< what was last said, by what it is about
  std::vector<std::string> news_;
};

}  // namespace softwall::campaign
