#include "campaign/core/parameters.hpp"

#include <algorithm>

#include "solver/case/case_schema.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;

/// The manager itself decides how a case starts and which flow it is.
bool is_swept_by_hand(const json::json_pointer& pointer) {
  const std::string text = pointer.to_string();
  return text != "/flow" && text != "/initial/type" && !text.starts_with("/initial/precursor");
}

void collect(const json& node, const json::json_pointer& at, const std::string& full_name,
             std::vector<Parameter>& all) {
  if (!node.contains("properties")) {
    if (is_swept_by_hand(at)) all.push_back({at.back(), full_name, at});
    return;
  }
  for (const auto& [key, child] : node.at("properties").items())
    collect(child, at / key, full_name.empty() ? key : full_name + "." + key, all);
}

}  // namespace

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> all = [] {
    std::vector<Parameter> found;
    collect(*case_schema().part(json::json_pointer("/physics")), json::json_pointer(), "", found);
    return found;
  }();
  return all;
}

const Parameter* find_parameter(const std::string& name) {
  const auto& all = parameters();
  const auto named = [&](const Parameter& parameter) {
    return parameter.name == name || parameter.full_name == name;
  };
  const auto found = std::find_if(all.begin(), all.end(), named);
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> parameter_names() {
  std::vector<std::string> names;
  for (const auto& parameter : parameters()) names.push_back(parameter.name);
  return names;
}

}  // namespace softwall::campaign
