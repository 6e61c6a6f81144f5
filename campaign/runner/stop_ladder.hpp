#pragma once

#include <algorithm>
#include <optional>

#include "campaign/launch/launcher.hpp"

namespace softwall::campaign {

/// How long an attempt may take to obey before it is asked more firmly.
struct StopGrace {
  double checkpoint_seconds = 300.0;  ///< to finish its step and write a checkpoint
  double terminate_seconds = 15.0;    ///< mpirun itself needs two seconds after SIGTERM
};

/// How firmly a user asks who has asked so often to stop.
[[nodiscard]] inline StopLevel level_of_requests(int requests) {
  return requests >= 3 ? StopLevel::kKill : requests == 2 ? StopLevel::kTerminate : StopLevel::kCheckpoint;
}

/// Checkpoint, then terminate, then kill, each when the time for the one before is over. Every request is
/// repeated while it is in force: a signal that reaches mpirun before it has started its ranks is lost.
class StopLadder {
 public:
  StopLadder(StopGrace grace, double now) : grace_(grace), began_(now), repeat_at_(now) {}

  /// The request to make now, if one is due: at least as firm as a user wants it to be.
  [[nodiscard]] std::optional<StopLevel> due(double now, StopLevel at_least = StopLevel::kCheckpoint) {
    const StopLevel level = std::max(level_at(now - began_), at_least);
    if (level == last_ && now < repeat_at_) return std::nullopt;
    last_ = level;
    repeat_at_ = now + kRepeatSeconds;
    return level;
  }

 private:
  static constexpr double kRepeatSeconds = 10.0;

  [[nodiscard]] StopLevel level_at(double elapsed) const {
    if (elapsed < grace_.checkpoint_seconds) return StopLevel::kCheckpoint;
    return elapsed < grace_.checkpoint_seconds + grace_.terminate_seconds ? StopLevel::kTerminate
                                                                          : StopLevel::kKill;
  }

  StopGrace grace_;
  double began_;
  StopLevel last_ = StopLevel::kCheckpoint;
  double repeat_at_;
};

}  // namespace softwall::campaign
