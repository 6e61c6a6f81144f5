#include "campaign/launch/launch_environment.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "campaign/system/find_program.hpp"
#include "campaign/system/work_marks.hpp"

namespace softwall::campaign {
namespace {

/// Variables of batch systems (Slurm, PBS, LSF, Grid Engine, Cobalt) and of process managers. With them
/// mpirun would take itself for a part of an allocation.
constexpr std::array<std::string_view, 17> kForeign = {
    "SLURM_",  "SLURMD_", "SRUN_", "SALLOC_", "SBATCH_", "PBS_",  "LSB_",  "LSF_",  "PE_HOSTFILE=",
    "COBALT_", "PMI_",    "PMI2_", "PMIX_",   "OMPI_",   "ORTE_", "PRTE_", "HYDRA_"};

/// Settings of Open MPI that only a person makes, because no mpirun leaves them behind.
constexpr std::array<std::string_view, 9> kChosen = {
    "OMPI_ALLOW_RUN_AS_ROOT", "OMPI_MCA_btl", "OMPI_MCA_coll", "OMPI_MCA_io", "OMPI_MCA_mpi_yield_when_idle",
    "OMPI_MCA_mtl",           "OMPI_MCA_osc", "OMPI_MCA_pml",  "OMPI_MCA_fs"};

template <class Prefixes>
bool begins_with_one_of(std::string_view text, const Prefixes& prefixes) {
  return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return text.starts_with(prefix); });
}

std::string_view name_in(std::string_view entry) { return entry.substr(0, entry.find('=') + 1); }

/// Whether a variable has a value; one that is there but empty counts as missing.
bool is_set(const std::vector<std::string>& environment, std::string_view name) {
  return std::ranges::any_of(environment, [&](const std::string& entry) {
    return name_in(entry) == name && entry.size() > name.size();
  });
}

/// What a job that we are in has left for its own programs, and what would change the answers of Slurm's
/// commands.
constexpr std::array<std::string_view, 10> kOfAnotherJob = {
    "SLURM_", "SLURMD_", "SRUN_", "SALLOC_", "SQUEUE_", "SACCT_", "SCANCEL_", "PMI_", "PMI2_", "PMIX_"};

}  // namespace

std::vector<std::string> scheduler_environment(const std::vector<std::string>& inherited) {
  std::vector<std::string> kept;
  std::ranges::copy_if(inherited, std::back_inserter(kept), [](const std::string& entry) {
    return entry.starts_with("SLURM_CONF") || !begins_with_one_of(entry, kOfAnotherJob);
  });
  return kept;
}

std::vector<std::string> launch_environment(const std::vector<std::string>& inherited,
                                            const std::filesystem::path& run_directory,
                                            const Scratch& scratch) {
  std::vector<std::string> settings = {
      run_directory_mark(run_directory),
      "TMPDIR=" + scratch.session().string(),
      "OMPI_MCA_btl_vader_backing_directory=" + scratch.shared_memory().string(),
      "OMP_NUM_THREADS=1",
  };
  if (!is_set(inherited, "HOME=")) settings.emplace_back("HOME=" + scratch.session().string());
  if (!is_set(inherited, "PATH=")) settings.emplace_back(std::string("PATH=") + kUsualPath);
  // A rank that waits lets others have its core: on a machine that does anything else besides, 2 ranks of a
  // small case took 1.7 s instead of 27 s (measured at a load of 15 on 2 cores).
  if (!is_set(inherited, "OMPI_MCA_mpi_yield_when_idle=")) {
    settings.emplace_back("OMPI_MCA_mpi_yield_when_idle=1");
  }
  if (geteuid() == 0) {
    settings.emplace_back("OMPI_ALLOW_RUN_AS_ROOT=1");
    settings.emplace_back("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1");
  }
  const std::size_t own = settings.size();
  for (const std::string& entry : inherited) {
    if (begins_with_one_of(entry, kForeign) && !begins_with_one_of(entry, kChosen)) continue;
    if (name_in(entry) == std::string(kSessionVariable) + "=") continue;  // of an attempt that started us
    bool replaced = false;
    for (std::size_t i = 0; i < own; ++i) replaced = replaced || settings[i].starts_with(name_in(entry));
    if (!replaced) settings.push_back(entry);
  }
  return settings;
}

std::vector<std::string> own_environment() {
  std::vector<std::string> entries;
  for (char** entry = environ; *entry != nullptr; ++entry) entries.emplace_back(*entry);
  return entries;
}

}  // namespace softwall::campaign
