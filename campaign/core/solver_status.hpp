#pragma once

#include <cstdint>

namespace softwall::campaign {

/// What a working solver reports of itself in status.json, about once a second.
struct Status {
  int attempt = 0;
  int ranks = 0;
  std::int64_t step = 0;
  double time = 0.0, end_time = 0.0;  ///< h/U_b
  double dt = 0.0;                    ///< h/U_b
  double seconds_per_step = 0.0;      ///< wall clock
};

}  // namespace softwall::campaign
