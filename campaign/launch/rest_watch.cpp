#include "campaign/launch/rest_watch.hpp"

#include <algorithm>
#include <system_error>

#include "campaign/system/clock.hpp"
#include "campaign/system/file_system.hpp"
#include "solver/run_directory/report_file.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/run_directory/status.hpp"
#include "solver/run_directory/summary.hpp"

namespace softwall::campaign {
namespace {

std::filesystem::file_time_type written(const std::filesystem::path& file) {
  std::error_code not_there;
  return std::filesystem::last_write_time(file, not_there);
}

bool has_ended(const RunFiles& run, int attempt) {
  const auto summary = read_report<Summary>(run.summary());
  return summary && summary->attempt >= attempt;
}

/// The status is written after a step, about once a second at most.
double seconds_per_step(const RunFiles& run) {
  const auto status = read_report<Status>(run.status());
  return status ? status->seconds_per_step : 0.0;
}

}  // namespace

RestWatch::Verdict RestWatch::look(const std::filesystem::path& run_directory, int attempt) {
  const RunFiles run{run_directory};
  if (lock_is_held(run.lock())) return Verdict::kAtWork;
  if (has_ended(run, attempt)) return Verdict::kAtRest;
  const double now = monotonic_seconds();
  const std::pair files{written(run.status()), written(run.log())};
  const auto [entry, is_new] = seen_.try_emplace(run_directory, Seen{files, now});
  Seen& seen = entry->second;
  if (seen.written != files) seen = {files, now};
  constexpr double kSteps = 10;
  const double quiet = std::max(quiet_, kSteps * seconds_per_step(run));
  return now - seen.since >= quiet ? Verdict::kAtRest : Verdict::kWatching;
}

}  // namespace softwall::campaign
