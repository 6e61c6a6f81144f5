#pragma once

#include <string>
#include <string_view>

#include "campaign/store/result_table.hpp"
#include "campaign/store/sqlite.hpp"

namespace softwall::campaign {

/// Runs one SQL statement of the user on a store, strictly for reading: a single statement, no ATTACH, no
/// PRAGMA that changes anything. From then on the connection allows nothing else. Throws SqliteError with
/// what is wrong.
[[nodiscard]] ResultTable run_query(Connection& store, std::string_view sql);

/// What to do about a query that was refused with these words: the column or table that was probably meant,
/// or where they are listed.
[[nodiscard]] std::string advice_for_query(Connection& store, const std::string& refusal);

/// Cases with results that are no longer part of the campaign: in results_all, not in results.
[[nodiscard]] std::int64_t left_out(Connection& store);

/// The view `results`, one row a case.
[[nodiscard]] ResultTable export_results(Connection& store);

}  // namespace softwall::campaign
