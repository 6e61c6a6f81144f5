#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

/// How the processes of an attempt are recognised, whoever started them and whether or not their parents
/// still live. Each of them inherits two variables: the run directory, and the number of the session that
/// mpirun leads. A variable alone would prove nothing, because anybody may set it or inherit it; so a process
/// must also be in that session, which nobody can enter from outside.
namespace softwall::campaign {

inline constexpr const char* kRunDirectoryVariable = "SOFTWALL_RUN_DIRECTORY";
inline constexpr const char* kSessionVariable = "SOFTWALL_SESSION";

/// The one spelling of a run directory: absolute and without symbolic links.
[[nodiscard]] std::filesystem::path canonical_run_directory(const std::filesystem::path& run_directory);

/// "SOFTWALL_RUN_DIRECTORY=...": what the environment of each process holds.
[[nodiscard]] std::string run_directory_mark(const std::filesystem::path& run_directory);

/// What the kernel said in one look at all processes of this machine.
class ProcessesAtWork {
 public:
  [[nodiscard]] static ProcessesAtWork look();
  /// Looks at the processes of a few sessions only. All others are asked for their session and not read.
  [[nodiscard]] static ProcessesAtWork look_in(const std::set<pid_t>& sessions);

  /// The live processes of this user that work in a run directory: mpirun and all ranks.
  [[nodiscard]] std::vector<pid_t> in(const std::filesystem::path& run_directory) const;
  [[nodiscard]] bool nobody() const { return by_directory_.empty(); }

 private:
  void add(pid_t pid);
  std::map<std::string, std::vector<pid_t>> by_directory_;  ///< by the one spelling
};

}  // namespace softwall::campaign
