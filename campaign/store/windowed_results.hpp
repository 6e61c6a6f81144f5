#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/store/store.hpp"

namespace softwall::campaign {

/// Results over another averaging window than the campaign file asks for; nothing on disk is changed.
struct WindowedResults {
  Store store;                        ///< a copy in memory
  std::vector<std::string> troubles;  ///< "G=1: why it has no result over this window", one a case
};

/// The results of all cases that are no precursors, made again from their statistics with the blocks that
/// start at or after `start`, h/U_b. A precursor's time is its own, and so are its averages. A case without
/// statistics that can be used has none: its stored result is over another window. Throws SqliteError.
[[nodiscard]] WindowedResults results_from(const std::filesystem::path& campaign_directory, double start);

}  // namespace softwall::campaign
