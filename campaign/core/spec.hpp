#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"
#include "campaign/core/start_order.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/case/json_schema.hpp"

namespace softwall::campaign {

/// A campaign file, checked by its schema (schemas/campaign.schema.json) but not yet expanded into cases.
/// The physics are kept as JSON: their defaults are those of the case and are filled in there.
struct CampaignSpec {
  std::string name;
  std::string description;
  nlohmann::json physics;               ///< common to all cases
  nlohmann::json precursor;             ///< what a precursor has otherwise; null: cases start by themselves
  nlohmann::json sweep;                 ///< "grid", "zip", "list", "exclude", all present
  nlohmann::json derive;                ///< expressions by the name of the parameter that they give
  std::optional<StartFrom> start_from;  ///< which case of the sweep starts which
  std::vector<IntervalTarget> until;    ///< when the cases of the sweep are precise enough
  nlohmann::json run;                   ///< members of case.run
  Execution execution;
  std::string source;  ///< file name, for messages
  std::string text;
};

/// A campaign file as far as it can be judged before its cases are made.
struct CheckedSpec {
  CampaignSpec spec;              ///< complete when there are no mistakes
  std::vector<Mistake> mistakes;  ///< every mistake that shows before expansion
  /// True when the members that describe cases have no mistakes. They are filled in then, so that `spec` can
  /// be expanded and its cases checked although another part of the file has mistakes.
  bool can_expand = false;
};

/// source: file name, for messages. Throws BadInput when the text is not JSON.
[[nodiscard]] CheckedSpec check_spec(const std::string& text, const std::string& source);

/// schemas/campaign.schema.json, its references to the case schema resolved.
[[nodiscard]] const JsonSchema& campaign_schema();

}  // namespace softwall::campaign
