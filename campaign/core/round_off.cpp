#include "campaign/core/round_off.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace softwall::campaign {

double without_round_off(double value) {
  constexpr double kExactIntegers = 9007199254740992.0;
  if (value == std::floor(value) && std::abs(value) < kExactIntegers) return value;
  std::array<char, 40> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.15g", value);
  std::from_chars(text.data(), text.data() + length, value);
  return value;
}

}  // namespace softwall::campaign
