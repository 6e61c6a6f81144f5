#pragma once

#include <string>

namespace softwall::campaign {

/// The present time of day as 23:59:59 in the local time zone.
[[nodiscard]] std::string local_time_of_day();

/// Seconds of a clock that never jumps and stands still while the machine sleeps; all limits are decided by
/// it.
[[nodiscard]] double monotonic_seconds();

/// A duration for users: "42 s", "12 min", "3 h 20 min", "2 d 4 h", "more than 1000 years".
[[nodiscard]] std::string describe_duration(double seconds);
/// The same of one that is not known to the second: "about 12 min".
[[nodiscard]] std::string describe_about(double seconds);

}  // namespace softwall::campaign
