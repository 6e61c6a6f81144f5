#pragma once

#include <algorithm>
#include <cmath>

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
