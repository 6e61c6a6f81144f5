#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"

/// What a campaign has yet to write, before it runs: for `softwall plan` and for refusing what cannot fit.
namespace softwall::campaign {

/// Bytes of fields; statistics, headers and HDF5's own tables are small beside them.
struct DiskNeed {
  double checkpoint_bytes = 0.0;
  double snapshot_bytes = 0.0;
  double film_bytes = 0.0;
  std::int64_t snapshots = 0;     ///< files that run.field_interval asks for
  std::int64_t film_moments = 0;  ///< files that run.plane_interval asks for
  [[nodiscard]] double bytes() const { return checkpoint_bytes + snapshot_bytes + film_bytes; }
};

/// What its cases have yet to write, up to their end times. observations[i] is of campaign.cases[i].
[[nodiscard]] DiskNeed disk_need(const Campaign& campaign, const std::vector<Observation>& observations);

/// "checkpoints 1.2 GB, 42 snapshots 3.1 GB, 800 moments of films 0.2 GB"; what there is none of is not
/// named.
[[nodiscard]] std::string words_of(const DiskNeed& need);

}  // namespace softwall::campaign
