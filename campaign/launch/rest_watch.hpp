#pragma once

#include <filesystem>
#include <map>
#include <utility>

namespace softwall::campaign {

/// Whether a solver still works in a run directory, where nobody else can say: it holds its lock, or its
/// status and its log change. Times of other machines are not compared with ours: a file that does not change
/// while we watch is at rest, and what was not watched for long enough is not known to be.
class RestWatch {
 public:
  explicit RestWatch(double quiet_seconds) : quiet_(quiet_seconds) {}

  /// What can be said of the attempt in a run directory now.
  enum class Verdict {
    kAtWork,    ///< somebody holds the solver's lock
    kWatching,  ///< nothing has been seen yet, but not for long enough
    kAtRest     ///< its end is on record, or nothing moved for long enough
  };
  [[nodiscard]] Verdict look(const std::filesystem::path& run_directory, int attempt);
  void forget(const std::filesystem::path& run_directory) { seen_.erase(run_directory); }

 private:
  struct Seen {
    std::pair<std::filesystem::file_time_type, std::filesystem::file_time_type> written;
    double since = 0.0;  ///< monotonic seconds from which on nothing was written
  };
  double quiet_;
  std::map<std::filesystem::path, Seen> seen_;
};

}  // namespace softwall::campaign
