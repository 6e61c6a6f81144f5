#pragma once

#include <optional>
#include <string>

#include "solver/run_directory/run_files.hpp"
#include "solver/run_directory/run_record.hpp"
#include "solver/run_directory/status.hpp"
#include "solver/run_directory/summary.hpp"

/// The small files of a run directory, as the manager reads and writes them. A file that is missing, not
/// complete or of another case counts as absent: it proves nothing.
namespace softwall::campaign {

[[nodiscard]] std::optional<Status> read_status(const RunFiles& run, const std::string& case_id);
[[nodiscard]] std::optional<Summary> read_summary(const RunFiles& run, const std::string& case_id);
[[nodiscard]] std::optional<RunRecord> read_run_record(const RunFiles& run);
void write_run_record(const RunFiles& run, const RunRecord& record);

}  // namespace softwall::campaign
