#pragma once

#include <string>
#include <vector>

#include "campaign/core/attempt.hpp"
#include "solver/run_directory/run_files.hpp"

/// history.json of a run directory: every attempt that has ended, as the store has them, so that a store made
/// again knows what a case has cost.
namespace softwall::campaign {

/// Replaces the file.
void write_history(const RunFiles& run, const std::string& case_id, const std::vector<PastAttempt>& attempts);

/// In order of their numbers; empty when there is no such file, or it is damaged or of another case.
[[nodiscard]] std::vector<PastAttempt> read_history(const RunFiles& run, const std::string& case_id);

}  // namespace softwall::campaign
