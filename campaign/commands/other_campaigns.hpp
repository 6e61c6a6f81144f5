#pragma once

#include <map>
#include <string>
#include <vector>

#include "campaign/commands/campaign_folder.hpp"

/// Several campaign files may share a folder, and its cases.
namespace softwall::campaign {

/// What the other files in the folder of a campaign ask for.
struct OtherCampaigns {
  std::map<std::string, std::string> asked_by;  ///< name of the file by the id of the case
  std::vector<std::string> unreadable;          ///< files that seem to be of a campaign, and cannot be read
};

[[nodiscard]] OtherCampaigns other_campaigns(const LoadedCampaign& loaded);

}  // namespace softwall::campaign
