#pragma once

#include <string>
#include <vector>

#include "solver/run_directory/block_statistics.hpp"

namespace softwall::analysis {

/// Every inconsistency of `statistics`, one sentence each; empty when there is none.
[[nodiscard]] std::vector<std::string> mistakes(const BlockStatistics& statistics);

}  // namespace softwall::analysis
