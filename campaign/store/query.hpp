#pragma once

#include <filesystem>
#include <string_view>

#include "campaign/store/result_table.hpp"

namespace softwall::campaign {

/// Runs one SQL statement of the user on the store of a campaign, strictly for reading: read-only connection,
/// a single statement, no ATTACH, no PRAGMA that changes anything. Throws SqliteError with what is wrong.
[[nodiscard]] ResultTable run_query(const std::filesystem::path& campaign_directory, std::string_view sql);

/// Cases with results that are no longer part of the campaign: in results_all, not in results.
[[nodiscard]] std::int64_t left_out(const std::filesystem::path& campaign_directory);

/// The view `results`, one row a case.
[[nodiscard]] ResultTable export_results(const std::filesystem::path& campaign_directory);

}  // namespace softwall::campaign
