#pragma once

#include <filesystem>
#include <stdexcept>

#include "solver/case/case.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {

/// A run directory that holds another case.
struct NotThisCase : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Make the run directory of a case and write its case.json again: `run` may have changed since the last
/// attempt, the physics cannot. initial_checkpoint: of the precursor, absolute; may be empty. Throws
/// std::system_error when it cannot be written, NotThisCase when the directory holds another case.
void prepare_run_directory(const Case& definition, const RunFiles& run,
                           const std::filesystem::path& initial_checkpoint);

/// Writes the case.json of a case that has ended again, where it is missing or cannot be read. False: it was
/// sound, or cannot be written; its results do not need it.
bool restore_case_file(const Case& definition, const RunFiles& run);

/// Remove the manager's half-written files of a moment when it was killed. The solver does so with its own.
void sweep_temporaries(const RunFiles& run);

}  // namespace softwall::campaign
