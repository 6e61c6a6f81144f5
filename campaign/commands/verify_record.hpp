#pragma once

#include <string>

#include "campaign/core/campaign.hpp"
#include "campaign/store/store.hpp"
#include "solver/run_directory/run_files.hpp"

namespace softwall::campaign {

/// In what the store's row of the newest attempt of a case differs from its summary.json; empty: in nothing.
/// Both were written from the same numbers, so that a bit that has changed in one of them shows.
[[nodiscard]] std::string difference_of_attempt(const Store& store, const CampaignCase& one,
                                                const RunFiles& run);

/// Of a case without a summary.json: whether its newest attempt can have ended as the store says.
[[nodiscard]] std::string trouble_with_no_summary(const Store& store, const std::string& case_id);

}  // namespace softwall::campaign
