#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <string>

namespace softwall {

/// A 64-bit number as 16 hexadecimal digits, leading zeros included: the form of case ids and digests.
[[nodiscard]] inline std::string hexadecimal(std::uint64_t value) {
  std::array<char, 16> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16);
  const std::string text(digits.data(), end);
  return std::string(digits.size() - text.size(), '0') + text;
}

}  // namespace softwall
