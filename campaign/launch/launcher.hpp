#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "campaign/core/attempt.hpp"

namespace softwall::campaign {

/// One launch of the solver for a case.
struct LaunchRequest {
  std::string case_id;
  std::filesystem::path run_directory;
  int attempt = 1;
  int ranks = 1;
  std::optional<double> wall_seconds = std::nullopt;  ///< the solver checkpoints and ends in time for this
  /// What the case still takes to its end, at the speed that was measured of it; empty: not known.
  std::optional<double> needed_seconds = std::nullopt;
};

/// What a scheduler says about the end of an attempt; it counts where the solver itself has left no word.
struct Verdict {
  AttemptOutcome outcome = AttemptOutcome::kLost;
  std::string reason;
};

/// What an attempt leaves behind once none of its processes is left.
struct EndedAttempt {
  std::string case_id;
  /// The exit status as a shell shows it: 128 + signal for a killed launcher. Empty: nobody saw it.
  std::optional<int> exit_code;
  std::optional<Verdict> verdict = std::nullopt;
};

/// How firmly an attempt is asked to end.
enum class StopLevel { kCheckpoint, kTerminate, kKill };

/// Text by which a launcher finds an attempt again, also when an earlier softwall started it. Only the
/// launcher knows what it means; softwall keeps it in run.json and in the store.
using Handle = std::string;

/// Where an attempt works, or worked last. An empty handle means whatever works in the run directory.
struct AttemptPlace {
  std::filesystem::path run_directory;
  Handle handle;
};

/// Where attempts run: this machine or a batch system. The one border behind which processes, queues and
/// their commands are known. make_launcher() chooses the one that a campaign asks for.
class Launcher {
 public:
  virtual ~Launcher() = default;

  /// Needed once before the first start(): finds what starting takes and, where ranks is not 0, tries whether
  /// so many can be started. Throws BadInput with the launcher's own words where they cannot.
  virtual void prepare(const std::filesystem::path& solver, int ranks) = 0;
  /// By which the attempt will be found that start() is about to start, should nobody live to see it return.
  /// Empty where an attempt ends together with the softwall that starts it.
  [[nodiscard]] virtual Handle intended(const LaunchRequest&) const { return {}; }
  /// Starts an attempt. Throws std::runtime_error when it cannot be started.
  [[nodiscard]] virtual Handle start(const LaunchRequest& request) = 0;
  /// Takes over an attempt that an earlier softwall started: true when it goes on by itself and collect()
  /// will report its end; false when attempts of this kind are to be ended, and started again from their
  /// checkpoint.
  [[nodiscard]] virtual bool adopt(const LaunchRequest& request, const Handle& handle) = 0;
  /// Whether attempts go on when the softwall that started them leaves. They are then left alone, and the
  /// next softwall adopts them.
  [[nodiscard]] virtual bool attempts_stay() const { return false; }
  /// Takes back the attempts that have only been prepared and wait here to be handed over: nobody does that
  /// once softwall has left. Their case ids; they count as never started.
  [[nodiscard]] virtual std::vector<std::string> take_back() { return {}; }
  /// What users should know about the launcher itself, once each.
  [[nodiscard]] virtual std::vector<std::string> news() { return {}; }
  /// Attempts that ended since the last call. Does not wait.
  virtual std::vector<EndedAttempt> collect() = 0;
  /// True when no attempt that was started or adopted is left to collect.
  [[nodiscard]] virtual bool idle() const = 0;

  /// The four below serve every attempt, whoever started it.
  /// One answer a place. Asks for all of them at once: a look at the processes of a machine, or at a queue,
  /// takes as long for one attempt as for ten thousand.
  [[nodiscard]] virtual std::vector<Presence> presences(const std::vector<AttemptPlace>& places) const = 0;
  [[nodiscard]] Presence presence(const std::filesystem::path& run_directory, const Handle& handle) const {
    return presences({{run_directory, handle}}).front();
  }
  virtual void stop(const std::filesystem::path& run_directory, const Handle& handle, StopLevel level) = 0;
  /// Removes what the launcher itself left for a run directory where nobody works any more.
  virtual void clean_up(const std::filesystem::path& run_directory) = 0;

  /// Minutes of a scheduler's time that an attempt would ask for; empty where nobody asks for any.
  [[nodiscard]] virtual std::optional<int> job_minutes(const LaunchRequest&) const { return std::nullopt; }
  /// Cores that attempts can use at once; empty when a scheduler decides.
  [[nodiscard]] virtual std::optional<int> capacity() const = 0;
};

/// Where a scheduler decides and the campaign sets no limit of its own.
inline constexpr int kUnlimitedCores = std::numeric_limits<int>::max();

/// Cores to use at once: as many as were asked for, or else (0) all that there are.
[[nodiscard]] inline int cores_to_use(int asked, const Launcher& launcher) {
  return asked > 0 ? asked : launcher.capacity().value_or(kUnlimitedCores);
}

}  // namespace softwall::campaign
