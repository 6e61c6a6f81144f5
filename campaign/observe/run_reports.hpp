#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "campaign/core/solver_status.hpp"
#include "solver/case/run_files.hpp"

/// The small files of a run directory, as the manager reads them. A file that is missing, not complete or of
/// another case counts as absent: it proves nothing.
namespace softwall::campaign {

[[nodiscard]] std::optional<Status> read_status(const RunFiles& run, const std::string& case_id);

/// summary.json, at every orderly end of an attempt.
struct Summary {
  int attempt = 0;
  std::string outcome;  ///< finished, interrupted, diverged or failed
  std::string reason;
  std::optional<int> exit_code;
  std::int64_t step = 0;
  double time = 0.0;  ///< h/U_b
  std::int64_t attempt_steps = 0;
  double wall_seconds = 0.0;
  double ns_per_cell_step = 0.0;
  std::string resumed_from;
  std::map<std::string, double> diagnostics;
  std::string version, git_revision, build_type, compiler, host, started, ended;
  int ranks = 0;
};
[[nodiscard]] std::optional<Summary> read_summary(const RunFiles& run, const std::string& case_id);

/// run.json, written by the manager: who works, or worked last, in the run directory.
struct RunRecord {
  std::string case_id;
  int attempt = 0;
  std::string handle;   ///< by which its launcher finds the attempt again; no one else knows what it means
  std::string host;     ///< machine of the softwall that started it
  std::string started;  ///< ISO 8601 UTC
};
[[nodiscard]] std::optional<RunRecord> read_run_record(const RunFiles& run);
void write_run_record(const RunFiles& run, const RunRecord& record);

}  // namespace softwall::campaign
