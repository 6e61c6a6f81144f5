#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

/// The parameters a sweep may vary: the leaves of "physics" in schemas/case.schema.json, by name. So a
/// parameter added to the schema can be swept without a change here.
namespace softwall::campaign {

struct Parameter {
  std::string name;                      ///< "viscosity_ratio"
  std::string full_name;                 ///< "solid.viscosity_ratio"
  nlohmann::json::json_pointer pointer;  ///< "/solid/viscosity_ratio", inside "physics"
};

/// All of them, in the schema's (alphabetical) order.
[[nodiscard]] const std::vector<Parameter>& parameters();

/// Finds a parameter by its name or full name; null when there is none.
[[nodiscard]] const Parameter* find_parameter(const std::string& name);

/// Names to suggest from.
[[nodiscard]] std::vector<std::string> parameter_names();

}  // namespace softwall::campaign
