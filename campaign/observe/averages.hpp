#pragma once

#include <optional>

#include "analysis/derived.hpp"
#include "campaign/core/campaign.hpp"
#include "solver/run_directory/run_files.hpp"

/// The averages that stand in a run directory, which the solver leaves beside every checkpoint.
namespace softwall::campaign {

/// The averaging window that begins at this time, h/U_b; 0: with the first block.
[[nodiscard]] analysis::DeriveOptions window_from(double start);

/// The averages of a case so far, over its window; nothing where there are none yet, or none that can be
/// used: they are a help and prove nothing.
[[nodiscard]] std::optional<analysis::DerivedQuantities> averages_so_far(const CampaignCase& campaign_case,
                                                                         const RunFiles& run);

/// Whether the intervals of these averages are as small as the campaign wants them.
[[nodiscard]] bool intervals_are_met(const CampaignCase& campaign_case, const RunFiles& run);

}  // namespace softwall::campaign
