#pragma once

#include "solver/case/case.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/run_directory/status.hpp"
#include "solver/run_directory/summary.hpp"

/// status.json and summary.json, written by rank 0.
namespace softwall::output {

/// A Status or a Summary with what both say of an attempt from its first moment on.
template <class Report>
[[nodiscard]] Report report_on(const Case& c, int attempt, int ranks) {
  Report report;
  report.case_id = c.id;
  report.attempt = attempt;
  report.ranks = ranks;
  report.end_time = c.run.end_time;
  return report;
}

/// Adds process, host and time of day. Throws std::system_error.
void write_status(const RunFiles& run, Status status);

/// Adds the outcome, the program, host and end of the attempt. Throws std::system_error.
void write_summary(const RunFiles& run, ExitCode code, Summary summary);

/// Whether summary.json says that this case has finished; false when it cannot be read.
[[nodiscard]] bool says_finished(const RunFiles& run, const std::string& case_id);

}  // namespace softwall::output
