#pragma once

#include <optional>

#include "campaign/launch/launcher.hpp"

namespace softwall::campaign {

/// How long an attempt may take to obey before it is asked more firmly.
struct StopGrace {
  double checkpoint_seconds = 300.0;  ///< to finish its step and write a checkpoint
  double terminate_seconds = 15.0;    ///< mpirun itself needs two seconds after SIGTERM
};

/// Checkpoint, then terminate, then kill, each when the time for the one before is over. Every request is
/// repeated while it is in force: a signal that reaches mpirun before it has started its ranks is lost.
class StopLadder {
 public:
  StopLadder(StopGrace grace, double now) : grace_(grace), began_(now), repeat_at_(now) {}

  /// The request to make now, if one is due.
  [[nodiscard]] std::optional<StopLevel> due(double now) {
    const StopLevel level = level_at(now - began_);
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
