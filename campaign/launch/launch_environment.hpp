#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/launch/scratch.hpp"

namespace softwall::campaign {

/// The environment of an attempt, made of the inherited one (entries NAME=value) and what an attempt needs.
///
/// An attempt is local, whatever the environment says: what a batch system, another mpirun or a process
/// manager has left there (an allocation of one slot, the address of another mpirun's daemon) is left out. Of
/// Open MPI's own settings those about messages and files stay. What mpirun cannot do without (HOME for a
/// user that has no entry in the system's list, PATH) is added where it is missing.
[[nodiscard]] std::vector<std::string> launch_environment(const std::vector<std::string>& inherited,
                                                          const std::filesystem::path& run_directory,
                                                          const Scratch& scratch);

/// The environment of a scheduler's commands, and by them of its jobs: the inherited one, without what
/// belongs to a job that this softwall may itself be in. Where the scheduler is found (SLURM_CONF) and how a
/// person chooses defaults (SBATCH_...) stays.
[[nodiscard]] std::vector<std::string> scheduler_environment(const std::vector<std::string>& inherited);

/// The environment of this process.
[[nodiscard]] std::vector<std::string> own_environment();

}  // namespace softwall::campaign
