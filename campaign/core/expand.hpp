#pragma once

#include "campaign/core/campaign.hpp"
#include "campaign/core/existing_cases.hpp"
#include "campaign/core/spec.hpp"

namespace softwall::campaign {

/// Every case of the campaign: precursors first, then the points of the sweep in the order written, each
/// once. Elastic walls start from the precursor that has their Reynolds number, domain and swept grid. A case
/// whose flow one of the existing cases has computed, with blocks that serve, is that case. Throws BadInput
/// with every mistake of every case.
[[nodiscard]] Campaign expand(const CampaignSpec& spec, const ExistingCases& existing = {});

}  // namespace softwall::campaign
