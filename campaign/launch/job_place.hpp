#pragma once

#include <filesystem>

#include "campaign/launch/slurm_job.hpp"

/// Whose the job is that a run directory names: folders are copied and moved with all their files, also while
/// jobs of theirs run.
namespace softwall::campaign {

enum class JobPlace {
  kHere,       ///< it was submitted for this run directory, under this path or another one
  kElsewhere,  ///< for another one, which is still there: this is a copy
  /// For a path where nothing is to be seen any more: this was moved, or is a copy whose original is gone.
  kUnclear
};

[[nodiscard]] JobPlace place_of(const JobRecord& job, const std::filesystem::path& run_directory);

}  // namespace softwall::campaign
