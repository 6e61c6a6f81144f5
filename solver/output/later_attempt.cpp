#include "solver/output/later_attempt.hpp"

#include "solver/run_directory/report_file.hpp"
#include "solver/run_directory/run_record.hpp"

namespace softwall::output {
namespace {

/// "attempt 3 has taken the place of this one, 2"; empty: none has.
std::string replacement(const RunFiles& run, const std::string& case_id, int attempt) {
  const auto record = read_report<RunRecord>(run.run_record(), case_id);
  if (!record || record->attempt <= attempt) return "";
  return "attempt " + std::to_string(record->attempt) + " has taken the place of this one, " +
         std::to_string(attempt);
}

}  // namespace

void leave_to_later_attempt(const RunFiles& run, const std::string& case_id, int attempt,
                            const parallel::Communicator& all) {
  if (attempt == 0) return;
  std::string words;
  agree_on_root(all, ExitCode::kFailed, [&] { words = replacement(run, case_id, attempt); });
  words = from_root(all, words);
  if (!words.empty()) throw ReplacedAttempt(words);
}

}  // namespace softwall::output
