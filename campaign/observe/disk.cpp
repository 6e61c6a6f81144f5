#include "campaign/observe/disk.hpp"

#include <algorithm>

#include "campaign/core/machine.hpp"
#include "campaign/core/words.hpp"
#include "solver/case/time_comparison.hpp"
#include "solver/run_directory/output_size.hpp"

namespace softwall::campaign {
namespace {

double bytes_of_checkpoints(const Case& one, const Observation& seen) {
  if (seen.newest_checkpoint || seen.state == CaseState::kFinished) return 0;  // its share is already there
  // One more than is kept: the oldest goes only when the newest is complete.
  return static_cast<double>(checkpoint_field_bytes(one.physics)) * (one.run.keep_checkpoints + 1);
}

/// Files of a kind that is written each `interval`: the one of t = 0 and one an interval, less those of the
/// time that is behind it.
std::int64_t files_to_come(double interval, const RunSpec& run, const Observation& seen) {
  if (interval <= 0 || seen.early || seen.state == CaseState::kDiverged) return 0;
  const double at_end = intervals_passed(run.end_time, interval);
  const double behind = intervals_passed(seen.time, interval);
  const std::int64_t first = seen.step == 0 ? 1 : 0;
  return static_cast<std::int64_t>(std::max(0.0, at_end - behind)) + first;
}

}  // namespace

DiskNeed disk_need(const Campaign& campaign, const std::vector<Observation>& observations) {
  DiskNeed need;
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    if (!observations[i].needs_person.empty()) continue;  // nothing of it will be written
    const Case& one = campaign.cases[i].definition;
    const std::int64_t film_bytes = film_moment_bytes(one.physics, one.run.planes);
    const std::int64_t snapshots = files_to_come(one.run.field_interval, one.run, observations[i]);
    const std::int64_t moments =
        film_bytes > 0 ? files_to_come(one.run.plane_interval, one.run, observations[i]) : 0;
    need.checkpoint_bytes += bytes_of_checkpoints(one, observations[i]);
    need.snapshot_bytes +=
        static_cast<double>(snapshot_field_bytes(one.physics)) * static_cast<double>(snapshots);
    need.snapshots += snapshots;
    need.film_bytes += static_cast<double>(film_bytes) * static_cast<double>(moments);
    need.film_moments += moments;
  }
  return need;
}

std::string words_of(const DiskNeed& need) {
  std::string words = "checkpoints " + gigabytes(need.checkpoint_bytes);
  if (need.snapshots > 0)
    words += ", " + counted(need.snapshots, "snapshot") + " " + gigabytes(need.snapshot_bytes);
  if (need.film_moments > 0)
    words += ", " + counted(need.film_moments, "moment") + " of films " + gigabytes(need.film_bytes);
  return words;
}

}  // namespace softwall::campaign
