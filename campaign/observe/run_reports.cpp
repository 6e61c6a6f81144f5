#include "campaign/observe/run_reports.hpp"

#include <nlohmann/json.hpp>

#include "solver/case/atomic_file.hpp"
#include "solver/run_directory/report_file.hpp"

namespace softwall::campaign {

std::optional<Status> read_status(const RunFiles& run, const std::string& case_id) {
  return read_report<Status>(run.status(), case_id);
}

std::optional<Summary> read_summary(const RunFiles& run, const std::string& case_id) {
  return read_report<Summary>(run.summary(), case_id);
}

std::optional<RunRecord> read_run_record(const RunFiles& run) {
  return read_report<RunRecord>(run.run_record());
}

void write_run_record(const RunFiles& run, const RunRecord& record) {
  write_atomically(run.run_record(), nlohmann::json(record).dump(2) + "\n");
}

}  // namespace softwall::campaign
