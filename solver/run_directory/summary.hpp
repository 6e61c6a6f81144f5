#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "solver/run_directory/exit_codes.hpp"

namespace softwall {

/// summary.json: how an attempt ended, written at every orderly end (schemas/summary.schema.json). A case has
/// succeeded when its summary says finished, names its id, and time >= end_time.
struct Summary {
  std::string case_id;
  int attempt = 0;
  std::string outcome;  ///< finished, interrupted, diverged or failed: outcome_of()
  std::string reason;   ///< human-readable
  std::optional<int> exit_code;
  std::int64_t step = 0;
  double time = 0.0, end_time = 0.0;  ///< h/U_b
  std::int64_t attempt_steps = 0;     ///< made by this attempt
  double wall_seconds = 0.0, ns_per_cell_step = 0.0;
  std::string checkpoint, resumed_from;       ///< relative to the run directory; empty: none
  std::map<std::string, double> diagnostics;  ///< by name; only finite ones come back from the file
  std::string version, git_revision, build_type, compiler;  ///< of softwall-dns
  std::string host;                                         ///< of rank 0
  int ranks = 0;
  std::string started, ended;  ///< ISO 8601, UTC
};

/// "finished", "interrupted", "diverged" or "failed".
[[nodiscard]] std::string outcome_of(ExitCode code);

/// A time or diagnostic that is not finite becomes 0 or null: JSON knows no infinity, and a diverged run has
/// one.
void to_json(nlohmann::json& json, const Summary& summary);
/// Throws nlohmann::json::exception when attempt, outcome or step is missing, or a member has a wrong type.
void from_json(const nlohmann::json& json, Summary& summary);

}  // namespace softwall
