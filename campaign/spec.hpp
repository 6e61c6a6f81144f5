#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "campaign/campaign.hpp"
#include "solver/case/json_schema.hpp"

namespace softwall::campaign {

/// A campaign file, checked by its schema (schemas/campaign.schema.json) but not yet expanded into cases.
/// The physics are kept as JSON: their defaults are those of the case and are filled in there.
struct CampaignSpec {
  std::string name;
  std::string description;
  nlohmann::json physics;    ///< common to all cases
  nlohmann::json precursor;  ///< what a precursor has otherwise; null: cases start by themselves
  nlohmann::json sweep;      ///< "grid", "zip", "list", "exclude", all present
  nlohmann::json run;        ///< members of case.run
  Execution execution;
  std::string source;  ///< file name, for messages
  std::string text;
};

/// Throws BadInput with every mistake that shows before expansion.
[[nodiscard]] CampaignSpec parse_campaign(const std::string& text, const std::string& source = "campaign");
[[nodiscard]] CampaignSpec read_campaign(const std::filesystem::path& file);

/// schemas/campaign.schema.json, its references to the case schema resolved.
[[nodiscard]] const JsonSchema& campaign_schema();

}  // namespace softwall::campaign
