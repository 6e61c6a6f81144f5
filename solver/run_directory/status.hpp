#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace softwall {

/// status.json: where a working solver is, about once a second (schemas/status.schema.json). It is a hint and
/// proves nothing.
struct Status {
  std::string case_id;
  int attempt = 0, ranks = 0;
  std::int64_t pid = 0;  ///< of rank 0
  std::string host;      ///< of rank 0
  std::int64_t step = 0;
  double time = 0.0, end_time = 0.0;  ///< h/U_b
  double dt = 0.0;                    ///< h/U_b
  std::string dt_limit;               ///< what binds the time step
  double seconds_per_step = 0.0;      ///< wall clock
  std::int64_t checkpoint_step = -1;  ///< of the newest checkpoint; -1: none
  double updated = 0.0;               ///< seconds since 1970, UTC
  double wall_seconds = 0.0;          ///< of this attempt so far; 0: not known
};

void to_json(nlohmann::json& json, const Status& status);
/// Throws nlohmann::json::exception when attempt or step is missing, or a member has a wrong type.
void from_json(const nlohmann::json& json, Status& status);

}  // namespace softwall
