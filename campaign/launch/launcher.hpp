#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/system/process_identity.hpp"

namespace softwall::campaign {

/// One launch of the solver for a case.
struct LaunchRequest {
  std::string case_id;
  std::filesystem::path run_directory;
  int attempt = 1;
  int ranks = 1;
  std::optional<double> wall_seconds;  ///< the solver checkpoints and ends in time for this
};

/// What stays of an attempt once none of its processes is left.
struct EndedAttempt {
  std::string case_id;
  int exit_code = 0;  ///< as a shell shows it: 128 + signal for a killed launcher
};

/// How firmly an attempt is asked to end.
enum class StopLevel { kCheckpoint, kTerminate, kKill };

/// Where attempts run: this machine today, a batch system later.
class Launcher {
 public:
  virtual ~Launcher() = default;

  /// Start an attempt. Throws std::runtime_error when it cannot be started.
  virtual ProcessIdentity start(const LaunchRequest& request) = 0;
  /// Attempts that ended since the last call. Does not wait.
  virtual std::vector<EndedAttempt> collect() = 0;
  virtual void stop(const std::string& case_id, StopLevel level) = 0;
  [[nodiscard]] virtual bool idle() const = 0;
};

}  // namespace softwall::campaign
