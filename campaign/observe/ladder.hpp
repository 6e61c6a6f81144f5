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
  std::string
      unreadable;  ///< why the newest cannot be read just now, so that nothing is known; empty: it can
};

/// Read the checkpoints of a run directory in full, newest first, until one is valid for this case; rename
/// those that are not. One that cannot be read ends the search, and is left alone. Good checkpoints are never
/// touched. Only while no solver works there.
[[nodiscard]] Ladder check_ladder(const RunFiles& run, const std::string& case_id);

/// Whether there have been checkpoints of which none is left under its name: some were set aside, or an
/// attempt ended in order after its first step.
[[nodiscard]] bool checkpoints_are_lost(const RunFiles& run, const std::string& case_id);

/// What is said of a case that is not started over by itself.
inline constexpr const char* kNoCheckpointLeft =
    "it had checkpoints, and none is there that can be used (is its disk mounted?); "
    "what was recorded of it is kept; to let it start from the beginning: resume --start-over";

/// All checkpoints of a run directory for the store, judged by their headers, then those just set aside.
[[nodiscard]] std::vector<CheckpointRecord> checkpoint_records(const RunFiles& run,
                                                               const std::vector<SetAside>& set_aside = {});

}  // namespace softwall::campaign
