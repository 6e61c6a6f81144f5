#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "campaign/launch/launcher.hpp"

/// What softwall submits to Slurm: one job an attempt. Pure text; slurm_launcher.cpp hands it over.
namespace softwall::campaign {

/// What a handle of the Slurm launcher holds. The name is what finds the job again: Slurm uses numbers again,
/// and where it was not heard that a job was accepted, there is no number.
struct JobRecord {
  std::string name;
  int attempt = 0;
  std::string number;     ///< of the job; empty: not known
  std::string directory;  ///< the run directory that it was submitted for; empty: not known
};
[[nodiscard]] Handle handle_of(const JobRecord& job);
/// Empty for a handle that some other launcher has made.
[[nodiscard]] std::optional<JobRecord> job_of(const Handle& handle);

/// "softwall.<campaign's folder>.<case's directory>.<attempt>.<hash of the run directory>": for users, and
/// the only one of its kind, also where a campaign's folder was copied. Only letters, digits and "._=+-".
[[nodiscard]] std::string job_name(const LaunchRequest& request);
/// "softwall.<campaign's folder>."
[[nodiscard]] std::string job_name_beginning(const std::filesystem::path& run_directory);

/// The script of the job, in the run directory. It is there for as long as the attempt is softwall's
/// business.
[[nodiscard]] std::filesystem::path job_script(const std::filesystem::path& run_directory);

/// What starts the ranks within a job, and the solver.
struct JobPrograms {
  std::filesystem::path starter;  ///< mpirun or srun
  std::filesystem::path solver;
};
/// job_line: a comment that says in which job the attempt runs (slurm_pack.hpp).
[[nodiscard]] std::string script_text(const LaunchRequest& request, const SlurmOptions& slurm,
                                      const JobPrograms& programs, const std::string& job_line);
/// The lines by which a job that Slurm begins again by itself ends at once.
[[nodiscard]] std::string leave_when_begun_again();

/// Time limit of the job in whole minutes: the campaign's, or less where the case is known to need less, a
/// quarter and the time before the signal added. Empty: the partition's.
[[nodiscard]] std::optional<int> time_limit(const LaunchRequest& request, const SlurmOptions& slurm);

/// Arguments of sbatch behind its name, without the script. They are arguments and no lines of the script,
/// because variables of the environment (SBATCH_...) would win over those.
[[nodiscard]] std::vector<std::string> submit_arguments(const LaunchRequest& request,
                                                        const SlurmOptions& slurm, const std::string& name);

/// Arguments of scancel for all jobs of this name, at a level; more than one call where more than one list.
[[nodiscard]] std::vector<std::vector<std::string>> cancel_arguments(const std::string& name, StopLevel level,
                                                                     const SlurmOptions& slurm);

/// Seconds after its start at which the solver is to have ended by its own clock; empty: whenever it likes.
[[nodiscard]] std::optional<double> solver_seconds(const LaunchRequest& request, const SlurmOptions& slurm);

}  // namespace softwall::campaign
