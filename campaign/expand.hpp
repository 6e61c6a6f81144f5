#pragma once

#include "campaign/campaign.hpp"
#include "campaign/spec.hpp"

namespace softwall::campaign {

/// A sweep of more cases than this is a slip of the pen; it is refused before anything is allocated for it.
inline constexpr std::size_t kMostCases = 10000;

/// Every case of the campaign: precursors first, then the points of the sweep in the order written, each
/// once. Elastic walls start from the precursor that has their Reynolds number, domain and swept grid. Throws
/// BadInput with every mistake of every case.
[[nodiscard]] Campaign expand(const CampaignSpec& spec);

}  // namespace softwall::campaign
