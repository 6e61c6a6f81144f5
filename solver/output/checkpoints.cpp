#include "solver/output/checkpoints.hpp"

#include "solver/output/agree.hpp"

namespace softwall::output {

namespace fs = std::filesystem;

namespace {

/// Temporary names of this program's own files, and of those that Open MPI keeps beside one while it is
/// written or tries its locks; nobody else's.
bool is_leftover(const std::string& name) {
  const bool of_open_mpi = (name.ends_with(".lock") && name.find(".tmp-") != std::string::npos) ||
                           name.find(".tmp.locktest.") != std::string::npos;
  if (name.ends_with(".tmp") || of_open_mpi)
    return name.starts_with("checkpoint-") || name.starts_with("fields-");
  if (name.starts_with(".planes-")) return name.find(".h5.tmp-") != std::string::npos;
  return name.starts_with(".planes.xdmf.tmp-") || name.starts_with(".fields.xdmf.tmp-") ||
         name.starts_with(".status.json.tmp-") || name.starts_with(".summary.json.tmp-") ||
         name.starts_with(".statistics.h5.tmp-") || name.starts_with(".spectra.h5.tmp-") ||
         name.starts_with(".layout.json.tmp-");
}

}  // namespace

Checkpoints::Checkpoints(RunFiles run, std::string case_id, int keep)
    : run_(std::move(run)), case_id_(std::move(case_id)), keep_(static_cast<std::size_t>(keep)) {}

void Checkpoints::sweep(const parallel::Communicator& all) const {
  agree_on_root(all, ExitCode::kIoFailure, [&] {
    for (const auto& folder : {run_.checkpoints(), run_.fields(), run_.planes(), run_.directory}) {
      if (!fs::is_directory(folder)) continue;
      for (const auto& entry : fs::directory_iterator(folder)) {
        if (is_leftover(entry.path().filename().string())) fs::remove(entry.path());
      }
    }
  });
}

std::optional<FoundCheckpoint> Checkpoints::newest_valid(const parallel::Communicator& all) {
  fs::path found;
  agree_on_root(all, ExitCode::kCheckpointRefused, [&] {
    for (const auto& file : checkpoint_ladder(run_)) {
      const CheckpointVerdict verdict = verify_checkpoint(file, case_id_);
      if (verdict.valid) {
        found = file;
        return;
      }
      // Going on from an older one would throw away what the newest may well hold.
      if (verdict.unreadable) throw AgreedError(ExitCode::kIoFailure, verdict.reason);
      refused_.insert(file);
      reasons_.push_back(verdict.reason);
    }
    if (reasons_.empty()) return;
    std::string message = "no checkpoint in " + run_.checkpoints().string() + " can be used:";
    for (const auto& reason : reasons_) message += "\n  " + reason;
    throw std::runtime_error(message + "\nRemove them to start this case from the beginning.");
  });
  found = from_root(all, found.string());
  if (found.empty()) return std::nullopt;
  FoundCheckpoint checkpoint{found, {}};
  agree(all, ExitCode::kCheckpointRefused, [&] { checkpoint.header = read_checkpoint_header(found); });
  return checkpoint;
}

void Checkpoints::prune(const fs::path& newest, const parallel::Communicator& all) {
  agree_on_root(all, ExitCode::kIoFailure, [&] {
    const CheckpointHeader header = read_checkpoint_header(newest);
    if (header.case_id != case_id_ || header.bytes != static_cast<std::int64_t>(fs::file_size(newest)) ||
        run_.checkpoint(header.step) != newest) {
      throw std::runtime_error("the checkpoint just written, " + newest.string() + ", does not read back");
    }
    refused_.erase(newest);
    std::size_t kept = 0;
    for (const auto& file : checkpoint_ladder(run_)) {
      if (refused_.count(file) == 0 && ++kept > keep_) fs::remove(file);
    }
  });
}

}  // namespace softwall::output
