#include "solver/output/initial_checkpoint.hpp"

#include <string>

#include "solver/case/time_comparison.hpp"
#include "solver/output/agree.hpp"

namespace softwall::output {
namespace {

CheckpointHeader readable_header(const std::filesystem::path& file) {
  try {
    return read_checkpoint_header(file);
  } catch (const std::exception& error) {
    throw AgreedError(ExitCode::kCheckpointRefused, file.string() + ": " + error.what());
  }
}

}  // namespace

CheckpointHeader check_initial_checkpoint(const std::filesystem::path& file, const InitialSpec& initial) {
  const std::string who = initial.type == InitialType::kNeighbour ? "neighbour" : "precursor";
  if (!std::filesystem::exists(file)) {
    throw AgreedError(ExitCode::kBadCase, "run.initial_checkpoint: " + file.string() + " does not exist");
  }
  CheckpointHeader header = readable_header(file);
  if (header.case_id != initial.precursor) {
    throw AgreedError(ExitCode::kBadCase, file.string() + " belongs to case " + header.case_id +
                                              ", physics.initial.precursor is " + initial.precursor);
  }
  if (!has_ended_at(header.time, header.step, initial.precursor_time)) {
    throw AgreedError(ExitCode::kBadCase, file.string() + " is of time " + std::to_string(header.time) +
                                              ", this case starts where the " + who + " has come to " +
                                              std::to_string(initial.precursor_time));
  }
  const CheckpointVerdict verdict = verify_checkpoint(file, initial.precursor);
  if (!verdict.valid) throw AgreedError(ExitCode::kCheckpointRefused, who + ": " + verdict.reason);
  return header;
}

}  // namespace softwall::output
