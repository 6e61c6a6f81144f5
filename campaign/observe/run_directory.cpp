#include "campaign/observe/run_directory.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "campaign/observe/run_reports.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/case/bad_input.hpp"

namespace softwall::campaign {
namespace {

std::optional<std::string> id_of_case_in(const RunFiles& run) {
  try {
    return read_case(run.case_file()).id;
  } catch (const BadInput&) {
    return std::nullopt;  // missing or damaged: it is written anew
  }
}

}  // namespace

void prepare_run_directory(const Case& definition, const RunFiles& run,
                           const std::filesystem::path& initial_checkpoint) {
  std::filesystem::create_directories(run.checkpoints());
  if (const auto id = id_of_case_in(run); id && *id != definition.id) {
    throw NotThisCase(run.directory.string() + " holds another case, " + *id + ", not " + definition.id);
  }
  Case prepared = definition;
  if (!initial_checkpoint.empty()) {
    prepared.run.initial_checkpoint = initial_checkpoint.lexically_relative(run.directory);
  }
  write_atomically(run.case_file(), to_json(prepared).dump(2) + "\n");
}

bool restore_case_file(const Case& definition, const RunFiles& run) {
  if (id_of_case_in(run)) return false;
  Case ended = definition;
  if (const auto summary = read_summary(run, definition.id)) ended.run.end_time = summary->end_time;
  try {
    prepare_run_directory(ended, run, {});
  } catch (const std::system_error&) {
    return false;
  }
  return true;
}

void sweep_temporaries(const RunFiles& run) {
  std::error_code ignored;  // a file that stays does no harm
  for (const auto& entry : std::filesystem::directory_iterator(run.directory, ignored)) {
    const std::string name = entry.path().filename();
    const bool ours = name.starts_with(".case.json.tmp-") || name.starts_with(".run.json.tmp-") ||
                      name.starts_with(".history.json.tmp-");
    if (ours) std::filesystem::remove(entry.path(), ignored);
  }
}

}  // namespace softwall::campaign
