#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/core/campaign.hpp"

/// Cases that an earlier version of the campaign file asked for: their run directories are kept, and nothing
/// of them is mixed into the results of the present campaign.
namespace softwall::campaign {

/// What the run directories below `folder` hold that the campaign does not ask for, precursors first. A
/// directory without a readable case file is none.
[[nodiscard]] std::vector<CampaignCase> left_over_cases(const Campaign& campaign,
                                                        const std::filesystem::path& folder);

/// Directories among those of the cases, "cases/notes", that are not of the campaign and have no readable
/// case file, so that nobody knows whose they are; in the order of their names.
[[nodiscard]] std::vector<std::string> directories_without_a_case(const Campaign& campaign,
                                                                  const std::filesystem::path& folder);

/// In what a left-over case differs from the case of the campaign that is most like it, for users:
/// "like G=1, but statistics.start_time 0.5 instead of 1". Empty when the campaign has no case of its kind.
[[nodiscard]] std::string why_left_over(const CampaignCase& left_over, const Campaign& campaign);

}  // namespace softwall::campaign
