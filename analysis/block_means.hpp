#pragma once

#include <string>
#include <vector>

#include "solver/run_directory/block_statistics.hpp"

/// Time means over chosen blocks. `weights` holds one number a block: the block's sampled time, or 0 to leave
/// it out; so a partial block counts for exactly the time that it has sampled.
namespace softwall::analysis {

/// Mean of a series. Throws std::runtime_error when the series is missing or no block has a positive weight.
[[nodiscard]] double mean_series(const BlockStatistics& statistics, const std::string& name,
                                 const std::vector<double>& weights);

/// Mean of a profile, one value a point of its location. Throws like mean_series.
[[nodiscard]] std::vector<double> mean_profile(const BlockStatistics& statistics, const std::string& name,
                                               const std::vector<double>& weights);

}  // namespace softwall::analysis
