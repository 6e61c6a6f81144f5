#include "solver/run_directory/run_record.hpp"

#include <nlohmann/json.hpp>

#include "solver/run_directory/report_file.hpp"

namespace softwall {

void to_json(nlohmann::json& json, const RunRecord& record) {
  json = {{"format", kReportFormat}, {"case_id", record.case_id}, {"attempt", record.attempt},
          {"handle", record.handle}, {"host", record.host},       {"started", record.started}};
}

void from_json(const nlohmann::json& json, RunRecord& record) {
  record.case_id = json.at("case_id").get<std::string>();
  record.attempt = json.at("attempt").get<int>();
  record.handle = json.value("handle", std::string());
  record.host = json.value("host", std::string());
  record.started = json.value("started", std::string());
  if (const auto process = json.find("process"); process != json.end()) {  // as softwall 0.1.0 wrote it
    record.handle = process->dump();
    record.host = process->value("host", std::string());
  }
}

}  // namespace softwall
