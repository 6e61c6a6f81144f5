#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace softwall {

/// run.json, written by the manager: who works, or worked last, in the run directory
/// (schemas/run.schema.json).
struct RunRecord {
  std::string case_id;
  int attempt = 0;
  std::string handle;   ///< by which its launcher finds the attempt again; no one else knows what it means
  std::string host;     ///< machine of the softwall that started it
  std::string started;  ///< ISO 8601, UTC
};

void to_json(nlohmann::json& json, const RunRecord& record);
/// Throws nlohmann::json::exception when case_id or attempt is missing, or a member has a wrong type.
void from_json(const nlohmann::json& json, RunRecord& record);

}  // namespace softwall
