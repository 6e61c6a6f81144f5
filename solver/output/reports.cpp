#include "solver/output/reports.hpp"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/case/atomic_file.hpp"
#include "solver/case/build_info.hpp"
#include "solver/case/input_file.hpp"

namespace softwall::output {

namespace {

using nlohmann::json;

json diagnostics_of(const Summary& s) {
  json values = json::object();
  for (const auto& [name, value] : s.diagnostics) values[name] = std::isfinite(value) ? json(value) : json();
  return values;
}

/// JSON knows no infinity; a diverged run has one.
double finite(double value) { return std::isfinite(value) ? value : 0.0; }

}  // namespace

std::string outcome_of(ExitCode code) {
  switch (code) {
    case ExitCode::kDone:
      return "finished";
    case ExitCode::kInterrupted:
      return "interrupted";
    case ExitCode::kDiverged:
      return "diverged";
    default:
      return "failed";
  }
}

void write_status(const RunFiles& run, const Status& s) {
  const auto now = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch());
  const json object = {{"format", 1},
                       {"case_id", s.case_id},
                       {"attempt", s.attempt},
                       {"pid", ::getpid()},
                       {"host", host_name()},
                       {"ranks", s.ranks},
                       {"step", s.step},
                       {"time", s.time},
                       {"end_time", s.end_time},
                       {"dt", s.dt},
                       {"dt_limit", s.dt_limit},
                       {"seconds_per_step", s.seconds_per_step},
                       {"checkpoint_step", s.checkpoint_step},
                       {"updated", now.count()}};
  write_atomically(run.status(), object.dump() + "\n", Durability::kQuick);
}

bool says_finished(const RunFiles& run, const std::string& case_id) {
  try {
    const json summary = json::parse(read_input_file(run.summary()));
    return summary.at("outcome") == "finished" && summary.at("case_id") == case_id;
  } catch (const std::exception&) {
    return false;
  }
}

void write_summary(const RunFiles& run, const Summary& s) {
  const BuildInfo build = build_info();
  const json object = {{"format", 1},
                       {"case_id", s.case_id},
                       {"attempt", s.attempt},
                       {"outcome", outcome_of(s.exit_code)},
                       {"reason", s.reason},
                       {"exit_code", static_cast<int>(s.exit_code)},
                       {"step", s.step},
                       {"time", finite(s.time)},
                       {"end_time", s.end_time},
                       {"attempt_steps", s.attempt_steps},
                       {"wall_seconds", s.wall_seconds},
                       {"ns_per_cell_step", s.ns_per_cell_step},
                       {"checkpoint", s.checkpoint},
                       {"resumed_from", s.resumed_from},
                       {"diagnostics", diagnostics_of(s)},
                       {"provenance",
                        {{"version", build.version},
                         {"git_revision", build.git_revision},
                         {"build_type", build.build_type},
                         {"compiler", build.compiler},
                         {"host", host_name()},
                         {"ranks", s.ranks},
                         {"started", s.started},
                         {"ended", utc_now()}}}};
  write_atomically(run.summary(), object.dump(2) + "\n");
}

}  // namespace softwall::output
