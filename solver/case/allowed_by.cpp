#include <nlohmann/json.hpp>
#include <string>

#include "solver/case/json_schema.hpp"
#include "solver/case/json_text.hpp"

namespace softwall {
namespace {

using nlohmann::json;

std::string with_article(const std::string& type) {
  if (type == "object" || type == "array" || type == "integer") return "an " + type;
  if (type == "string") return "text in quotes";
  if (type == "boolean") return "true or false";
  return "a " + type;
}

/// 1e9 as 1000000000, not as 1000000000.0.
std::string number_text(const json& number) { return normalised_number(number.get<double>()).dump(); }

std::string bounds(const json& node) {
  const bool low = node.contains("minimum"), high = node.contains("maximum");
  if (low && high)
    return " from " + number_text(node.at("minimum")) + " to " + number_text(node.at("maximum"));
  std::string text;
  if (low) text += " of at least " + number_text(node.at("minimum"));
  if (node.contains("exclusiveMinimum")) text += " greater than " + number_text(node.at("exclusiveMinimum"));
  if (high)
    text += std::string(text.empty() ? "" : " and") + " of at most " + number_text(node.at("maximum"));
  return text;
}

std::string size_limits(const json& node) {
  std::string text;
  if (node.contains("minLength")) text += " of at least " + node.at("minLength").dump() + " character(s)";
  if (node.contains("maxLength"))
    text += std::string(text.empty() ? "" : " and") + " of at most " + node.at("maxLength").dump() +
            " characters";
  if (node.contains("minProperties"))
    text += " with at least " + node.at("minProperties").dump() + " member(s)";
  if (node.contains("minItems")) text += " with at least " + node.at("minItems").dump() + " member(s)";
  if (node.contains("maxItems"))
    text +=
        std::string(text.empty() ? "" : " and") + " with at most " + node.at("maxItems").dump() + " members";
  return text;
}

std::string choices(const json& values) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ", ") + value.dump();
  return values.size() == 1 ? text : "one of " + text;
}

}  // namespace

std::string allowed_by(const json& node) {
  if (node.contains("const")) return node.at("const").dump();
  if (node.contains("enum")) return choices(node.at("enum"));
  if (!node.contains("type")) return node.value("description", std::string("something else"));
  const json& type = node.at("type");
  std::string text;
  for (const auto& one : type.is_array() ? type : json::array({type}))
    text += (text.empty() ? "" : " or ") + with_article(one);
  text += bounds(node) + size_limits(node);
  if (node.contains("pattern")) text += " matching " + node.at("pattern").get<std::string>();
  return text;
}

}  // namespace softwall
