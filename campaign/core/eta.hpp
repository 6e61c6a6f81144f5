#pragma once

#include <map>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "solver/run_directory/status.hpp"

namespace softwall::campaign {

/// Wall-clock seconds until all unfinished cases are done on this many cores: measured speed where a case has
/// run, that of its like where one of them has, a default before that. Blocked cases cost nothing.
[[nodiscard]] double remaining_seconds(const Campaign& campaign, const std::vector<Observation>& observations,
                                       const std::map<std::string, Status>& working, int cores);

/// Core-nanoseconds per cell and step, the mean of what was measured for cases of the same flow and
/// precision; the default of estimate.hpp when nothing was.
[[nodiscard]] double measured_ns_per_cell_step(const Campaign& campaign,
                                               const std::vector<Observation>& observations,
                                               const Physics& physics);

}  // namespace softwall::campaign
