#pragma once

#include <string>

#include "solver/output/agree.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::output {

/// A later attempt has taken the place of this one, which leaves without a word in the run directory.
struct ReplacedAttempt : AgreedError {
  explicit ReplacedAttempt(const std::string& message) : AgreedError(ExitCode::kFailed, message) {}
};

/// A batch system may start an attempt that everybody took for gone, and a machine that was cut off may come
/// back with one, after the manager has begun a later one. The lock tells them apart on one machine; between
/// machines not every file system does. So whoever is about to write asks run.json whose turn it is.
/// Collective. Throws ReplacedAttempt. Attempt 0 was started by hand, and is never replaced.
void leave_to_later_attempt(const RunFiles& run, const std::string& case_id, int attempt,
                            const parallel::Communicator& all);

}  // namespace softwall::output
