#include "solver/output/reports.hpp"

#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "solver/case/atomic_file.hpp"
#include "solver/run_directory/build_info.hpp"
#include "solver/run_directory/report_file.hpp"

namespace softwall::output {

void write_status(const RunFiles& run, Status status) {
  const auto now = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch());
  status.pid = ::getpid();
  status.host = host_name();
  status.updated = now.count();
  write_atomically(run.status(), nlohmann::json(status).dump() + "\n", Durability::kQuick);
}

bool says_finished(const RunFiles& run, const std::string& case_id) {
  const auto summary = read_report<Summary>(run.summary(), case_id);
  return summary && summary->outcome == "finished";
}

void write_summary(const RunFiles& run, ExitCode code, Summary summary) {
  const BuildInfo build = build_info();
  summary.exit_code = static_cast<int>(code);
  summary.outcome = outcome_of(code);
  summary.version = build.version;
  summary.git_revision = build.git_revision;
  summary.build_type = build.build_type;
  summary.compiler = build.compiler;
  summary.host = host_name();
  summary.ended = utc_now();
  write_atomically(run.summary(), nlohmann::json(summary).dump(2) + "\n");
}

}  // namespace softwall::output
