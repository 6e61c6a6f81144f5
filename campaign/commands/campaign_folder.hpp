#pragma once

#include <filesystem>

#include "campaign/core/campaign.hpp"

namespace softwall::campaign {

/// A campaign and the folder it lives in.
struct LoadedCampaign {
  Campaign campaign;
  std::filesystem::path folder;
};

/// From a campaign file, or from a folder with a campaign.json. Throws BadInput.
[[nodiscard]] LoadedCampaign load_campaign(const std::filesystem::path& path);

/// The folder that a path means, with a results store in it. Throws BadInput when there is none.
[[nodiscard]] std::filesystem::path folder_with_store(const std::filesystem::path& path);

}  // namespace softwall::campaign
