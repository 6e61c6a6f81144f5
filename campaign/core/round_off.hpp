#pragma once

namespace softwall::campaign {

/// Without the last digits, where round-off is: 3 * 0.1 is 0.3, as if it had been written by hand.
[[nodiscard]] double without_round_off(double value);

}  // namespace softwall::campaign
