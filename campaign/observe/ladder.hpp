#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/core/checkpoint_record.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {

/// A checkpoint that cannot be used: renamed to <name>.bad, never removed.
struct SetAside {
  std::filesystem::path file;  ///< its new name
  std::string reason;
};

struct Ladder {
  std::optional<std::filesystem::path> newest;  ///< newest valid checkpoint
  CheckpointHeader header;                      ///< of it
  std::vector<SetAside> set_aside;
};

/// Read the checkpoints of a run directory in full, newest first, until one is valid for this case; rename
/// those that are not. Good checkpoints are never touched. Only while no solver works there.
[[nodiscard]] Ladder check_ladder(const RunFiles& run, const std::string& case_id);

/// All checkpoints of a run directory for the store, judged by their headers, then those just set aside.
[[nodiscard]] std::vector<CheckpointRecord> checkpoint_records(const RunFiles& run,
                                                               const std::vector<SetAside>& set_aside = {});

}  // namespace softwall::campaign
