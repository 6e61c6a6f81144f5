#include "campaign/observe/ladder.hpp"

#include <stdexcept>

#include "campaign/observe/run_reports.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/case/hexadecimal.hpp"

namespace softwall::campaign {
namespace {

std::filesystem::path free_name_for_bad(const std::filesystem::path& file) {
  std::filesystem::path name = file.string() + ".bad";
  for (int i = 2; std::filesystem::exists(name); ++i) name = file.string() + ".bad" + std::to_string(i);
  return name;
}

CheckpointRecord record_of(const RunFiles& run, const std::filesystem::path& file) {
  CheckpointRecord record;
  record.path = file.lexically_relative(run.directory);
  try {
    const CheckpointHeader header = read_checkpoint_header(file);
    record.step = header.step;
    record.time = header.time;
    record.bytes = header.bytes;
    record.digest = hexadecimal(header.xxh3);
    record.valid = true;
  } catch (const std::runtime_error& error) {
    record.reason = error.what();
  }
  return record;
}

}  // namespace

Ladder check_ladder(const RunFiles& run, const std::string& case_id) {
  Ladder ladder;
  for (const auto& file : checkpoint_ladder(run)) {
    const CheckpointVerdict verdict = verify_checkpoint(file, case_id);
    if (verdict.valid) {
      ladder.newest = file;
      ladder.header = verdict.header;
      break;
    }
    if (verdict.unreadable) {
      ladder.unreadable = verdict.reason;
      break;
    }
    const auto bad = free_name_for_bad(file);
    std::filesystem::rename(file, bad);
    ladder.set_aside.push_back({bad, verdict.reason});
  }
  if (!ladder.set_aside.empty()) sync_directory(run.checkpoints());
  return ladder;
}

bool checkpoints_are_lost(const RunFiles& run, const std::string& case_id) {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(run.checkpoints(), none)) {
    const std::string name = entry.path().filename();
    if (name.starts_with("checkpoint-") && name.find(".h5.bad") != std::string::npos) return true;
  }
  const auto summary = read_summary(run, case_id);
  return summary && summary->step > 0 &&
         (summary->outcome == "interrupted" || summary->outcome == "finished");
}

std::vector<CheckpointRecord> checkpoint_records(const RunFiles& run,
                                                 const std::vector<SetAside>& set_aside) {
  std::vector<CheckpointRecord> records;
  for (const auto& file : checkpoint_ladder(run)) records.push_back(record_of(run, file));
  for (const SetAside& bad : set_aside) {
    CheckpointRecord record = record_of(run, bad.file);
    record.valid = false;
    record.reason = bad.reason;
    records.push_back(record);
  }
  return records;
}

}  // namespace softwall::campaign
