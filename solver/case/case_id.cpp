#include "solver/case/case_id.hpp"

#include <xxhash.h>

#include <algorithm>
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

/// Most texts are plain words, for which the quotation marks are all that JSON adds.
void append_text(const std::string& value, std::string& text) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (std::ranges::all_of(value, is_plain)) {
    text += '"';
    text += value;
    text += '"';
  } else {
    text += json(value).dump();
  }
}

void append(const json& value, std::string& text) {
  if (value.is_object()) {
    char separator = '{';
    for (const auto& [key, member] : value.get_ref<const json::object_t&>()) {  // sorted by key
      text += separator;
      append_text(key, text);
      text += ':';
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
    append_number(normalised_number(value.get<double>()), text);
  } else if (value.is_string()) {
    append_text(value.get_ref<const std::string&>(), text);
  } else {
    text += value.dump();
  }
}

void drop_layer_height(json& identity) {
  const auto domain = identity.find("domain");
  if (domain == identity.end()) return;
  domain->erase("layer_height");
  if (domain->empty()) identity.erase(domain);
}

/// The default of today, which is not the one that ids leave out: it is written wherever it holds.
bool is_reference_map(const json& identity) {
  const auto solid = identity.find("solid");
  return solid != identity.end() && solid->value("formulation", "") == "reference_map";
}

}  // namespace

std::string canonical_text(const json& value) {
  std::string text;
  append(value, text);
  return text;
}

std::string case_id(const json& physics) {
  json identity = case_schema().member_without_defaults("physics", physics);
  if (identity.value("flow", "") == "rigid_channel") {
    identity.erase("solid");
    drop_layer_height(identity);
  }
  if (is_reference_map(identity)) identity.at("solid").erase("interface");
  const std::string text = canonical_text(identity);
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return hexadecimal(hash.high64);
}

}  // namespace softwall
