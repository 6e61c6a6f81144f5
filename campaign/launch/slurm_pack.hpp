#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/launch/launcher.hpp"

/// Several small cases in one job of Slurm. Each of them keeps its own script, log, lock and attempt; the
/// script of the job starts theirs side by side on one node, passes on what is asked of the job, or of one of
/// them, and notes how each has ended.
namespace softwall::campaign {

/// Name of a job of one or more cases: of one, that of its attempt; of more,
/// "softwall.<folder>.<number>-cases.<hash of their attempts>". The same attempts make the same name.
[[nodiscard]] std::string pack_name(const std::vector<LaunchRequest>& cases);
/// What they ask for together: the ranks of all, and the time of the longest.
[[nodiscard]] LaunchRequest together(const std::vector<LaunchRequest>& cases);

/// The script of a job of several cases, in the run directory of the first.
[[nodiscard]] std::filesystem::path pack_script(const std::filesystem::path& run_directory);
[[nodiscard]] std::string pack_text(const std::vector<LaunchRequest>& cases);

/// The line by which a case's script says in which job it runs; without a name: in none so far.
[[nodiscard]] std::string job_line(const std::string& name);
/// The name of the job in which the attempt of a run directory runs, by its script; "" when it has not been
/// submitted, `otherwise` when the script does not say, nothing when there is no script.
[[nodiscard]] std::optional<std::string> job_in(const std::filesystem::path& run_directory,
                                                const std::string& otherwise);

/// The exit status that the job's script has noted of an attempt, as a shell shows it; empty before its end.
[[nodiscard]] std::optional<int> packed_exit_code(const std::filesystem::path& run_directory, int attempt);
/// Asks one case of a job to end: the job's script looks for such requests every few seconds.
void ask_packed(const std::filesystem::path& run_directory, StopLevel level);
/// Removes what this file has made in a run directory.
void remove_pack_files(const std::filesystem::path& run_directory);

}  // namespace softwall::campaign
