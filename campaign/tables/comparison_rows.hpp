#pragma once

#include "campaign/store/result_table.hpp"
#include "campaign/store/sqlite.hpp"

namespace softwall::campaign {

/// The paper's tables for other programs: one row a case of ours and row of the paper beside which it stands,
/// under each reading of G ("table", "text", ...); NULL for both where it stands beside none. Each quantity X
/// has X_ci95 and, as the paper prints it, X_paper. Throws SqliteError when the store cannot be read.
[[nodiscard]] ResultTable comparison_rows(Connection& store);

}  // namespace softwall::campaign
