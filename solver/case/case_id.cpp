#include "solver/case/case_id.hpp"

#include <xxhash.h>

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "solver/case/case_schema.hpp"
#include "solver/case/hexadecimal.hpp"
#include "solver/case/json_text.hpp"

namespace softwall {
namespace {

using nlohmann::json;

/// std::to_chars without precision is the shortest text that reads back exactly, the same on every machine.
void append_number(const json& value, std::string& text) {
  std::array<char, 32> digits{};
  char* const end = digits.data() + digits.size();
  const auto result = value.is_number_float() ? std::to_chars(digits.data(), end, value.get<double>())
                                              : std::to_chars(digits.data(), end, value.get<std::int64_t>());
  text.append(digits.data(), result.ptr);
}

void append(const json& value, std::string& text) {
  if (value.is_object()) {
    char separator = '{';
    for (const auto& [key, member] : value.items()) {  // nlohmann's objects are sorted by key
      text += separator + json(key).dump() + ":";
      append(member, text);
      separator = ',';
    }
    text += value.empty() ? "{}" : "}";
  } else if (value.is_array()) {
    text += "[";
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i > 0) text += ",";
      append(value[i], text);
    }
    text += "]";
  } else if (value.is_number()) {
    append_number(value, text);
  } else {
    text += value.dump();
  }
}

}  // namespace

std::string canonical_text(const json& value) {
  std::string text;
  append(normalised(value), text);
  return text;
}

std::string case_id(const json& physics) {
  json identity = normalised(physics);
  if (identity.value("flow", "") == "rigid_channel") {
    identity.erase("solid");
    if (identity.contains("domain")) identity["domain"].erase("layer_height");
  }
  json whole = {{"physics", std::move(identity)}};
  case_schema().fill_defaults(whole);
  json& filled = whole.at("physics");
  if (filled.contains("solid") && filled["solid"].value("formulation", "") == "reference_map")
    filled["solid"].erase("interface");
  case_schema().drop_defaults(whole);
  const std::string text = canonical_text(whole.at("physics"));
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return hexadecimal(hash.high64);
}

}  // namespace softwall
