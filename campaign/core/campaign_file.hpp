#pragma once

#include <filesystem>
#include <string>

#include "campaign/core/campaign.hpp"

namespace softwall::campaign {

/// The campaign that a file describes, with all its cases. Throws BadInput with every mistake of the file and
/// of every case. source: file name, for messages.
[[nodiscard]] Campaign parse_campaign(const std::string& text, const std::string& source = "campaign");
[[nodiscard]] Campaign read_campaign(const std::filesystem::path& file);

}  // namespace softwall::campaign
