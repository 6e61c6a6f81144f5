#pragma once

#include "campaign/core/campaign.hpp"
#include "campaign/core/spec.hpp"

namespace softwall::campaign {

/// Every case of the campaign: precursors first, then the points of the sweep in the order written, each
/// once. Elastic walls start from the precursor that has their Reynolds number, domain and swept grid. Throws
/// BadInput with every mistake of every case.
[[nodiscard]] Campaign expand(const CampaignSpec& spec);

}  // namespace softwall::campaign
