#pragma once

#include <string>

#include "campaign/store/query.hpp"
#include "campaign/store/store.hpp"
#include "tests/campaign/core/examples.hpp"

/// A small campaign, a result, and short ways to ask the store, for tests.
namespace softwall::campaign::tests {

/// A rigid precursor and the paper's six elastic cases under the reading of its tables.
inline Campaign paper_campaign() {
  nlohmann::json document = elastic_campaign();
  document["sweep"] = nlohmann::json::parse(R"({
    "grid": {"G": [0.5, 1, 2, 4]},
    "list": [{"G": 1, "viscosity_ratio": 0.1}, {"G": 1, "viscosity_ratio": 10}]})");
  return campaign_of(document);
}

inline const CampaignCase& case_with(const Campaign& campaign, double g, double viscosity_ratio) {
  for (const CampaignCase& candidate : campaign.cases) {
    const auto& solid = candidate.definition.physics.solid;
    if (solid && solid->G == g && solid->viscosity_ratio == viscosity_ratio) return candidate;
  }
  throw std::runtime_error("no such case in the example");
}

/// Re_tau and all else made of one number, so that a mix-up of columns or cases shows.
inline analysis::DerivedQuantities result_made_of(double seed) {
  analysis::DerivedQuantities derived;
  double offset = 0.0;
  for (const auto& [name, member] : analysis::kMeasuredMembers) {
    derived.*member = {seed + offset, 0.01 * (seed + offset)};
    offset += 0.125;
  }
  derived.window_start = 10.0;
  derived.window_end = 50.0;
  derived.blocks = 40;
  return derived;
}

inline AttemptEnd failed_at(std::int64_t step) {
  AttemptEnd end;
  end.outcome = AttemptOutcome::kFailed;
  end.step = step;
  return end;
}

/// First cell of the first row, as text.
inline std::string answer(Store& store, const std::string& sql) {
  Statement rows = store.connection().prepare(sql);
  return rows.step() ? rows.text(0) : "(no row)";
}

inline std::size_t number_of_cases(Store store) {
  return std::stoul(answer(store, "SELECT count(*) FROM cases"));
}

/// A campaign of this one case.
inline Campaign campaign_with(const CampaignCase& only) {
  Campaign campaign;
  campaign.name = "one case";
  campaign.cases = {only};
  return campaign;
}

/// What an action is refused with; empty when it is not.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const SqliteError& error) {
    return error.what();
  }
  return "";
}

}  // namespace softwall::campaign::tests
