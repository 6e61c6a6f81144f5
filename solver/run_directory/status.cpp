#include "solver/run_directory/status.hpp"

#include <nlohmann/json.hpp>

#include "solver/run_directory/report_file.hpp"

namespace softwall {

void to_json(nlohmann::json& json, const Status& status) {
  json = {{"format", kReportFormat},
          {"case_id", status.case_id},
          {"attempt", status.attempt},
          {"pid", status.pid},
          {"host", status.host},
          {"ranks", status.ranks},
          {"step", status.step},
          {"time", status.time},
          {"end_time", status.end_time},
          {"dt", status.dt},
          {"dt_limit", status.dt_limit},
          {"seconds_per_step", status.seconds_per_step},
          {"checkpoint_step", status.checkpoint_step},
          {"updated", status.updated},
          {"wall_seconds", status.wall_seconds}};
}

void from_json(const nlohmann::json& json, Status& status) {
  status.case_id = json.value("case_id", std::string());
  status.attempt = json.at("attempt").get<int>();
  status.ranks = json.value("ranks", 0);
  status.pid = json.value("pid", std::int64_t{0});
  status.host = json.value("host", std::string());
  status.step = json.at("step").get<std::int64_t>();
  status.time = number_in(json, "time");
  status.end_time = number_in(json, "end_time");
  status.dt = number_in(json, "dt");
  status.dt_limit = json.value("dt_limit", std::string());
  status.seconds_per_step = number_in(json, "seconds_per_step");
  status.checkpoint_step = json.value("checkpoint_step", std::int64_t{-1});
  status.updated = number_in(json, "updated");
  status.wall_seconds = number_in(json, "wall_seconds");
}

}  // namespace softwall
