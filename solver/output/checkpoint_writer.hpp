#pragma once

#include <filesystem>

#include "solver/output/checkpoint_contents.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::output {

/// Who writes: goes into the header.
struct Author {
  std::string case_id;
  int attempt = 0;
};

/// Writes the state and the record as run.checkpoint(state.step): a new file under a temporary name, closed,
/// read back for its digest, headed, synced, renamed, folder synced; so a reader finds a whole checkpoint or
/// none. Collective. A state that is not finite throws AgreedError (76) and nothing is written; an I/O error
/// ends the program with exit code 75 and leaves every published checkpoint as it was.
std::filesystem::path write_checkpoint(const RunFiles& run, const Author& author, time::State& state,
                                       const CheckpointContents& record, const time::Setup& setup);

/// Size of a checkpoint without its statistics, bytes.
[[nodiscard]] std::int64_t checkpoint_bytes(time::State& state, const grid::Grid& grid);

}  // namespace softwall::output
