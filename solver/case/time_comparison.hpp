#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

/// Comparisons of simulated times. A time is the sum of many steps, so that ten steps of 0.1 do not add up to
/// 1 exactly; whoever asks whether an end is reached or an interval is over asks here, solver and manager
/// alike.
namespace softwall {

/// Times that differ by less than this part of themselves are the same time. Far more than the round-off of a
/// million steps, far less than a step.
inline constexpr double kTimeRoundOff = 1e-9;

/// Whether a run that is at `time` has come to `goal`, both h/U_b.
[[nodiscard]] inline bool has_reached(double time, double goal) {
  return time >= goal - kTimeRoundOff * std::abs(goal);
}

/// Whether a run that is at `time` after `steps` steps stopped because it had come to `goal`: a few steps
/// beyond at most, and not on the way to a later end.
[[nodiscard]] inline bool has_ended_at(double time, std::int64_t steps, double goal) {
  constexpr double kFewSteps = 10;  // of mean length: steps of one run differ
  return has_reached(time, goal) && (time - goal) * static_cast<double>(steps) <= kFewSteps * time;
}

/// How many whole intervals have passed at `time`; interval > 0.
[[nodiscard]] inline double intervals_passed(double time, double interval) {
  return std::floor(time / interval * (1 + kTimeRoundOff));
}

/// How much of the way to `goal` > 0 is done, 0 to 100 [%]: a run that went past an end that was lowered
/// later is done, not more than done.
[[nodiscard]] inline double percent_done(double time, double goal) {
  return has_reached(time, goal) ? 100.0 : std::clamp(100.0 * time / goal, 0.0, 99.0);
}

}  // namespace softwall
