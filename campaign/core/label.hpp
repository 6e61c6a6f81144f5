#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "campaign/core/campaign.hpp"

/// Labels are what users call the cases of a campaign: distinct, short, and kept for as long as a case is
/// there. They are never identity.
namespace softwall::campaign {

/// Of a case id, in the names of directories and of labels that need it.
inline constexpr std::size_t kIdDigits = 8;

/// "G=0.5_mu=10" from {{"G", 0.5}, {"viscosity_ratio", 10}}, numbers with all their digits; of any length.
[[nodiscard]] std::string label_of(const std::vector<std::pair<std::string, nlohmann::json>>& parameters);

/// Letters, digits and . _ = - only, others become "-"; never empty, never starting with "." or "-".
[[nodiscard]] std::string safe_label(const std::string& text);

/// Makes the labels of a campaign safe as file names, at most 80 characters long and distinct: those that are
/// longer, or that several cases would bear, end in the beginning of the case's id. Sets the directories,
/// too. kept: ids of cases whose directory stays; their labels too, unless several of them bear the same.
void make_labels_distinct(Campaign& campaign, const std::unordered_set<std::string>& kept = {});

/// "cases/<label>-<first 8 of the id>".
[[nodiscard]] std::string case_directory(const std::string& label, const std::string& case_id);

/// The label in the name of a case's directory, without the id behind it.
[[nodiscard]] std::string label_in_directory(const std::string& directory, const std::string& case_id);

}  // namespace softwall::campaign
