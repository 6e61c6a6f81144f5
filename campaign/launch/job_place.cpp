#include "campaign/launch/job_place.hpp"

#include <system_error>

namespace softwall::campaign {

/// A job works by the path that it was submitted with, wherever the files have gone since. The name holds a
/// hash of that path, so that most answers need no look at the disk.
JobPlace place_of(const JobRecord& job, const std::filesystem::path& run_directory) {
  const LaunchRequest here{.case_id = "", .run_directory = run_directory, .attempt = job.attempt};
  if (job.name == job_name(here)) return JobPlace::kHere;
  std::error_code not_seen;
  if (job.directory.empty() || !std::filesystem::exists(job.directory, not_seen)) return JobPlace::kUnclear;
  const bool same = std::filesystem::equivalent(job.directory, run_directory, not_seen);
  if (not_seen) return JobPlace::kUnclear;
  return same ? JobPlace::kHere : JobPlace::kElsewhere;
}

}  // namespace softwall::campaign
