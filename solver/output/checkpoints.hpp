#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "solver/parallel/mpi.hpp"
#include "solver/run_directory/checkpoint_header.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::output {

struct FoundCheckpoint {
  std::filesystem::path file;
  CheckpointHeader header;
};

/// The generations of checkpoints in one run directory: which to start from, which to delete. Collective
/// functions; the disk is looked at by rank 0 alone. Files that were refused are kept as evidence and never
/// counted.
class Checkpoints {
 public:
  Checkpoints(RunFiles run, std::string case_id, int keep);

  /// Removes what killed writers left behind. Only while holding the run's lock.
  void sweep(const parallel::Communicator& all) const;

  /// The newest valid checkpoint; nothing when there is none at all. Those passed over are listed in
  /// refused(). Throws AgreedError (77) with every reason when there are checkpoints and none can be used.
  [[nodiscard]] std::optional<FoundCheckpoint> newest_valid(const parallel::Communicator& all);

  /// One line for each checkpoint that was passed over, with the reason; on rank 0.
  [[nodiscard]] const std::vector<std::string>& refused() const { return reasons_; }

  /// Deletes the oldest generations, once `newest` is published and reads back as the checkpoint of this
  /// step.
  void prune(const std::filesystem::path& newest, const parallel::Communicator& all);

 private:
  RunFiles run_;
  std::string case_id_;
  std::size_t keep_;
  std::set<std::filesystem::path> refused_;
  std::vector<std::string> reasons_;
};

}  // namespace softwall::output
