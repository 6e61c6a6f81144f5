#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace softwall {

/// Deeper than any document of ours; deep nesting is an accident or an attack.
inline constexpr std::size_t kJsonDepthLimit = 64;

/// A hundred times the largest campaign file imaginable; keeps the time to refuse a hostile one short.
inline constexpr std::size_t kJsonValueLimit = 200000;

/// Strict JSON from an untrusted text. Refused, with line and column where there is one: syntax errors, byte
/// order marks, NUL bytes, bytes that are not UTF-8, keys given twice, numbers that are not finite in double
/// precision, nesting deeper than kJsonDepthLimit, text after the end. Numbers come back normalised (see
/// below). Throws BadInput under the name `source`.
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::string& source);

/// One representation per value: every whole number of at most 2^53 in size is an integer, every other number
/// a double, and -0 is 0. So 1, 1.0 and 1e0 are one number for types, comparisons and hashes alike. Throws
/// std::invalid_argument for a number that is not finite.
[[nodiscard]] nlohmann::json normalised_number(double value);

/// Normalises every number inside a value in this way.
[[nodiscard]] nlohmann::json normalised(nlohmann::json value);

/// A member of an object that may be absent or null.
template <class Value>
[[nodiscard]] std::optional<Value> optional_member(const nlohmann::json& object, const char* name) {
  const auto member = object.find(name);
  if (member == object.end() || member->is_null()) return std::nullopt;
  return member->template get<Value>();
}

}  // namespace softwall
