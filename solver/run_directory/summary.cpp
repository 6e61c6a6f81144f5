#include "solver/run_directory/summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/run_directory/report_file.hpp"

namespace softwall {
namespace {

using nlohmann::json;

json diagnostics_of(const Summary& summary) {
  json values = json::object();
  for (const auto& [name, value] : summary.diagnostics) {
    values[name] = std::isfinite(value) ? json(value) : json();
  }
  return values;
}

json provenance_of(const Summary& summary) {
  return {{"version", summary.version},
          {"git_revision", summary.git_revision},
          {"build_type", summary.build_type},
          {"compiler", summary.compiler},
          {"host", summary.host},
          {"ranks", summary.ranks},
          {"started", summary.started},
          {"ended", summary.ended}};
}

void read_provenance(const json& provenance, Summary& summary) {
  const auto text = [&](const char* name) { return provenance.value(name, std::string()); };
  summary.version = text("version");
  summary.git_revision = text("git_revision");
  summary.build_type = text("build_type");
  summary.compiler = text("compiler");
  summary.host = text("host");
  summary.started = text("started");
  summary.ended = text("ended");
  summary.ranks = provenance.value("ranks", 0);
}

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

void to_json(json& object, const Summary& summary) {
  object = {{"format", kReportFormat},
            {"case_id", summary.case_id},
            {"attempt", summary.attempt},
            {"outcome", summary.outcome},
            {"reason", summary.reason},
            {"step", summary.step},
            {"time", std::isfinite(summary.time) ? summary.time : 0.0},
            {"end_time", summary.end_time},
            {"attempt_steps", summary.attempt_steps},
            {"wall_seconds", summary.wall_seconds},
            {"ns_per_cell_step", summary.ns_per_cell_step},
            {"checkpoint", summary.checkpoint},
            {"resumed_from", summary.resumed_from},
            {"diagnostics", diagnostics_of(summary)},
            {"provenance", provenance_of(summary)}};
  if (summary.exit_code) object["exit_code"] = *summary.exit_code;
}

void from_json(const json& object, Summary& summary) {
  summary.case_id = object.value("case_id", std::string());
  summary.attempt = object.at("attempt").get<int>();
  summary.outcome = object.at("outcome").get<std::string>();
  summary.reason = object.value("reason", std::string());
  if (object.contains("exit_code")) summary.exit_code = object.at("exit_code").get<int>();
  summary.step = object.at("step").get<std::int64_t>();
  summary.time = number_in(object, "time");
  summary.end_time = number_in(object, "end_time");
  summary.attempt_steps = object.value("attempt_steps", std::int64_t{0});
  summary.wall_seconds = number_in(object, "wall_seconds");
  summary.ns_per_cell_step = number_in(object, "ns_per_cell_step");
  summary.checkpoint = object.value("checkpoint", std::string());
  summary.resumed_from = object.value("resumed_from", std::string());
  const json diagnostics = object.value("diagnostics", json::object());
  for (const auto& [name, value] : diagnostics.items()) {
    if (value.is_number()) summary.diagnostics[name] = value.get<double>();
  }
  read_provenance(object.value("provenance", json::object()), summary);
}

}  // namespace softwall
