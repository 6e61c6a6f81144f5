#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "campaign/launch/launcher.hpp"

namespace softwall::campaign {

/// Starts attempts on this machine: mpirun, directly from argument arrays (no shell sees a name).
/// start() must be called from one thread: the kernel's parent-death signal belongs to the thread that forks.
///
/// Each attempt has its own session, so that neither Ctrl-C at the terminal nor its end reaches more than
/// softwall, and works in its run directory, which softwall's own current folder may not outlive. If softwall
/// itself is killed, the kernel sends SIGUSR1 to mpirun, which asks every rank to write a checkpoint
/// and end.
class ProcessLauncher final : public Launcher {
 public:
  struct Programs {
    std::filesystem::path mpirun;
    std::filesystem::path solver;
  };

  ProcessLauncher() = default;
  explicit ProcessLauncher(Programs programs) : programs_(std::move(programs)) {}
  /// Ends what still runs, at once: only an error of the runner itself leaves anything.
  ~ProcessLauncher() override;
  ProcessLauncher(const ProcessLauncher&) = delete;
  ProcessLauncher& operator=(const ProcessLauncher&) = delete;

  /// mpirun of the PATH, for this solver; tries it out.
  void prepare(const std::filesystem::path& solver, int ranks) override;
  /// The handle is mpirun's ProcessIdentity as JSON. It is for users: attempts are found by the
  /// marks of their processes (system/work_marks.hpp), because ranks may outlive their mpirun.
  [[nodiscard]] Handle start(const LaunchRequest& request) override;
  /// False: solvers of this machine end with the softwall that started them.
  [[nodiscard]] bool adopt(const LaunchRequest&, const Handle&) override { return false; }
  std::vector<EndedAttempt> collect() override;
  [[nodiscard]] bool idle() const override { return running_.empty(); }
  [[nodiscard]] std::vector<Presence> presences(const std::vector<AttemptPlace>& places) const override;
  void stop(const std::filesystem::path& run_directory, const Handle& handle, StopLevel level) override;
  void clean_up(const std::filesystem::path& run_directory) override;
  [[nodiscard]] std::optional<int> capacity() const override;

 private:
  struct Running {
    std::filesystem::path run_directory;
    pid_t leader = 0;    ///< mpirun, also the number of its process group and session
    bool ended = false;  ///< mpirun has ended; its ranks may not have
    int exit_code = 0;
    double ended_at = 0.0;  ///< monotonic seconds
  };
  void note_end(Running& attempt) const;

  Programs programs_;
  std::map<std::string, Running> running_;  ///< by case id
};

/// The command line of an attempt.
[[nodiscard]] std::vector<std::string> launch_arguments(const ProcessLauncher::Programs& programs,
                                                        const LaunchRequest& request);

}  // namespace softwall::campaign
