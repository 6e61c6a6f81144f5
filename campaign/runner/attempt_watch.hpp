#pragma once

#include <cstdint>
#include <optional>

#include "campaign/runner/stop_ladder.hpp"
#include "solver/run_directory/status.hpp"

namespace softwall::campaign {

/// What the runner keeps in mind about an attempt at work.
struct AttemptWatch {
  int attempt = 0;
  int ranks = 0;
  Handle handle;                  ///< by which the launcher finds it
  std::int64_t first_step = 0;    ///< safe step it started from
  std::optional<Status> status;   ///< newest report of this attempt
  double moved_at = 0.0;          ///< monotonic seconds when its step was last seen to advance
  std::optional<StopLadder> end;  ///< set when it is being ended because it stalled

  void report(const Status& newest, double now) {
    if (!status || newest.step > status->step) moved_at = now;
    status = newest;
  }
  [[nodiscard]] bool is_stalled(double now, double limit) const { return now - moved_at > limit; }
};

}  // namespace softwall::campaign
