#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "campaign/core/campaign_file.hpp"
#include "solver/case/bad_input.hpp"

/// Valid campaign files to start from, and small helpers, for tests.
namespace softwall::campaign::tests {

inline nlohmann::json elastic_campaign() {
  return nlohmann::json::parse(R"({
    "format": 1, "name": "walls",
    "physics": {"grid": {"nx": 48, "ny_fluid": 64, "ny_solid": 16, "nz": 48}, "time_step": {"safety": 0.7}},
    "precursor": {"grid": {"nx": 32}, "statistics": {"start_time": 50}, "run": {"end_time": 100}},
    "sweep": {"grid": {"G": [1, 2], "viscosity_ratio": [0.1, 1]}},
    "run": {"end_time": 50, "checkpoint_steps": 10}})");
}

inline Campaign campaign_of(const nlohmann::json& document) { return parse_campaign(document.dump()); }

/// The labels of all cases, in their order.
inline std::string labels(const Campaign& campaign) {
  std::string text;
  for (const auto& c : campaign.cases) text += (text.empty() ? "" : " ") + c.definition.label;
  return text;
}

/// What is said against a document; empty when it is accepted.
inline std::string complaint_about(const nlohmann::json& document) {
  try {
    static_cast<void>(campaign_of(document));
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace softwall::campaign::tests
