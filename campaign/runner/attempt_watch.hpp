#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "campaign/launch/launcher.hpp"
#include "campaign/runner/stop_ladder.hpp"
#include "solver/run_directory/status.hpp"

namespace softwall::campaign {

/// What the runner keeps in mind about an attempt at work.
struct AttemptWatch {
  /// Of an attempt that its launcher knows by this handle. now: monotonic seconds; step: safe one it starts
  /// from.
  AttemptWatch(const LaunchRequest& request, Handle known_by, double now, std::int64_t step = 0)
      : attempt(request.attempt),
        ranks(request.ranks),
        handle(std::move(known_by)),
        first_step(step),
        moved_at(now),
        imported_step(step) {}

  int attempt;
  int ranks;
  Handle handle;                           ///< by which the launcher finds it
  std::int64_t first_step;                 ///< safe step it started from
  std::optional<Status> status;            ///< newest report of this attempt
  Presence presence = Presence::kRunning;  ///< when it was adopted
  bool begun = false;                      ///< its solver has been seen inside the run directory
  std::string why_ended;                   ///< for people, when it is being ended
  double moved_at;                         ///< monotonic seconds when its step was last seen to advance
  std::int64_t imported_step;              ///< of the checkpoint whose averages were last recorded
  double imported_at = 0.0;                ///< and when, monotonic seconds
  std::optional<StopLadder> end;           ///< set when it is being ended
  bool stalled = false;                    ///< because it made no step

  void report(const Status& newest, double now) {
    if (!status || newest.step > status->step) moved_at = now;
    status = newest;
  }
  [[nodiscard]] bool is_stalled(double now, double limit) const { return now - moved_at > limit; }
};

}  // namespace softwall::campaign
