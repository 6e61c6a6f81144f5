#include "campaign/observe/run_reports.hpp"

#include <fstream>

#include <nlohmann/json.hpp>

#include "solver/case/atomic_file.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

constexpr int kFormat = 1;

std::filesystem::path run_record_file(const RunFiles& run) { return run.directory / "run.json"; }

/// The object in a file, of this format; null when there is none.
json read_object(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return nullptr;
  json object = json::parse(in, nullptr, false);
  if (!object.is_object()) return nullptr;
  const auto format = object.find("format");
  return format != object.end() && *format == kFormat ? object : json(nullptr);
}

/// A report of this case, turned into a T; members of a wrong type make the whole report worthless.
template <typename T, typename Read>
std::optional<T> read_report(const std::filesystem::path& file, const std::string& case_id, Read read) {
  try {
    const json object = read_object(file);
    if (object.is_null() || object.at("case_id") != case_id) return std::nullopt;
    return read(object);
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::string text(const json& object, const char* name) { return object.value(name, std::string()); }

/// JSON has no infinity or NaN: the solver writes null for them.
double number(const json& object, const char* name) {
  const auto member = object.find(name);
  return member != object.end() && member->is_number() ? member->get<double>() : 0.0;
}

void read_provenance(const json& object, Summary& summary) {
  const json provenance = object.value("provenance", json::object());
  summary.version = text(provenance, "version");
  summary.git_revision = text(provenance, "git_revision");
  summary.build_type = text(provenance, "build_type");
  summary.compiler = text(provenance, "compiler");
  summary.host = text(provenance, "host");
  summary.started = text(provenance, "started");
  summary.ended = text(provenance, "ended");
  summary.ranks = provenance.value("ranks", 0);
}

}  // namespace

std::optional<Status> read_status(const RunFiles& run, const std::string& case_id) {
  return read_report<Status>(run.status(), case_id, [](const json& object) {
    return Status{object.at("attempt").get<int>(),
                  object.value("ranks", 0),
                  object.at("step").get<std::int64_t>(),
                  number(object, "time"),
                  number(object, "end_time"),
                  number(object, "dt"),
                  number(object, "seconds_per_step")};
  });
}

std::optional<Summary> read_summary(const RunFiles& run, const std::string& case_id) {
  return read_report<Summary>(run.summary(), case_id, [](const json& object) {
    Summary summary;
    summary.attempt = object.at("attempt").get<int>();
    summary.outcome = object.at("outcome").get<std::string>();
    summary.reason = text(object, "reason");
    if (object.contains("exit_code")) summary.exit_code = object.at("exit_code").get<int>();
    summary.step = object.at("step").get<std::int64_t>();
    summary.time = number(object, "time");
    summary.attempt_steps = object.value("attempt_steps", std::int64_t{0});
    summary.wall_seconds = number(object, "wall_seconds");
    summary.ns_per_cell_step = number(object, "ns_per_cell_step");
    summary.resumed_from = text(object, "resumed_from");
    const json diagnostics = object.value("diagnostics", json::object());
    for (const auto& [name, value] : diagnostics.items()) {
      if (value.is_number()) summary.diagnostics[name] = value.get<double>();
    }
    read_provenance(object, summary);
    return summary;
  });
}

std::optional<RunRecord> read_run_record(const RunFiles& run) {
  try {
    const json object = read_object(run_record_file(run));
    if (object.is_null()) return std::nullopt;
    RunRecord record{object.at("case_id").get<std::string>(), object.at("attempt").get<int>(),
                     text(object, "handle"), text(object, "host"), text(object, "started")};
    if (const auto process = object.find("process"); process != object.end()) {  // as softwall 0.1.0 wrote it
      record.handle = process->dump();
      record.host = text(*process, "host");
    }
    return record;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

void write_run_record(const RunFiles& run, const RunRecord& record) {
  const json object = {{"format", kFormat},       {"case_id", record.case_id}, {"attempt", record.attempt},
                       {"handle", record.handle}, {"host", record.host},       {"started", record.started}};
  write_atomically(run_record_file(run), object.dump(2) + "\n");
}

}  // namespace softwall::campaign
