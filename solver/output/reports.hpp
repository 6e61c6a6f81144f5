#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "solver/case/exit_codes.hpp"
#include "solver/case/run_files.hpp"

/// status.json and summary.json, as their schemas describe them; written by rank 0.
namespace softwall::output {

struct Status {
  std::string case_id;
  int attempt = 0, ranks = 0;
  std::int64_t step = 0;
  double time = 0, end_time = 0, dt = 0;
  std::string dt_limit;
  double seconds_per_step = 0;
  std::int64_t checkpoint_step = -1;
};

struct Summary {
  std::string case_id;
  int attempt = 0, ranks = 0;
  ExitCode exit_code = ExitCode::kFailed;
  std::string reason;
  std::int64_t step = 0;
  double time = 0, end_time = 0;
  std::int64_t attempt_steps = 0;
  double wall_seconds = 0, ns_per_cell_step = 0;
  std::string checkpoint, resumed_from;  ///< relative to the run directory
  std::string started;                   ///< ISO 8601, UTC
  std::map<std::string, double> diagnostics;
};

/// Throws std::system_error.
void write_status(const RunFiles& run, const Status& status);
void write_summary(const RunFiles& run, const Summary& summary);

/// Whether summary.json says that this case has finished; false when it cannot be read.
[[nodiscard]] bool says_finished(const RunFiles& run, const std::string& case_id);

/// "finished", "interrupted", "diverged" or "failed".
[[nodiscard]] std::string outcome_of(ExitCode code);

}  // namespace softwall::output
