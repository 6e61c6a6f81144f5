#include "campaign/observe/disk.hpp"

#include <algorithm>

#include "campaign/core/machine.hpp"
#include "campaign/core/words.hpp"
#include "solver/case/time_comparison.hpp"
#include "solver/run_directory/checkpoint_size.hpp"

namespace softwall::campaign {
namespace {

double bytes_of_checkpoints(const Case& one, const Observation& seen) {
  if (seen.newest_checkpoint || seen.state == CaseState::kFinished) return 0;  // its share is already there
  // One more than is kept: the oldest goes only when the newest is complete.
  return static_cast<double>(checkpoint_field_bytes(one.physics)) * (one.run.keep_checkpoints + 1);
}

/// The one of t = 0 and one an interval, less those of the time that is behind it.
std::int64_t snapshots_to_come(const RunSpec& run, const Observation& seen) {
  if (run.field_interval <= 0 || seen.early || seen.state == CaseState::kDiverged) return 0;
  const double at_end = intervals_passed(run.end_time, run.field_interval);
  const double behind = intervals_passed(seen.time, run.field_interval);
  const std::int64_t first = seen.step == 0 ? 1 : 0;
  return static_cast<std::int64_t>(std::max(0.0, at_end - behind)) + first;
}

}  // namespace

DiskNeed disk_need(const Campaign& campaign, const std::vector<Observation>& observations) {
  DiskNeed need;
  for (std::size_t i = 0; i < campaign.cases.size(); ++i) {
    const Case& one = campaign.cases[i].definition;
    const std::int64_t snapshots = snapshots_to_come(one.run, observations[i]);
    need.checkpoint_bytes += bytes_of_checkpoints(one, observations[i]);
    need.snapshot_bytes +=
        static_cast<double>(snapshot_field_bytes(one.physics)) * static_cast<double>(snapshots);
    need.snapshots += snapshots;
  }
  return need;
}

std::string words_of(const DiskNeed& need) {
  const std::string checkpoints = "checkpoints " + gigabytes(need.checkpoint_bytes);
  if (need.snapshots == 0) return checkpoints;
  return checkpoints + " and " + counted(need.snapshots, "snapshot") + " " + gigabytes(need.snapshot_bytes);
}

}  // namespace softwall::campaign
