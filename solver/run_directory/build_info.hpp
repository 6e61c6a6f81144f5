#pragma once

#include <chrono>
#include <string>

namespace softwall {

/// Which program computed a result: goes into summary.json, checkpoints and the results store.
struct BuildInfo {
  std::string version;       ///< of the project, "0.2.0"; raised whenever the solver's numbers change
  std::string git_revision;  ///< 12 digits, "-modified" behind them when the tree had changes; or "unknown"
  std::string build_type;    ///< CMake's: Release, Debug, ...
  std::string compiler;      ///< "GNU 12.2.0"
};

[[nodiscard]] BuildInfo build_info();

[[nodiscard]] std::string host_name();

/// Now, as ISO 8601 in UTC with milliseconds: "2024-05-06T07:08:09.012Z". Whole seconds would not tell in
/// which order the short cases of a campaign followed each other.
[[nodiscard]] std::string utc_now();
/// Any moment as such a text, also one before 1970.
[[nodiscard]] std::string utc_text(std::chrono::milliseconds since_1970);

}  // namespace softwall
