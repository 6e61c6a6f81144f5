#pragma once

#include <filesystem>
#include <string>

#include "campaign/core/campaign.hpp"
#include "campaign/core/existing_cases.hpp"

namespace softwall::campaign {

/// The campaign that a file describes, with all its cases. Throws BadInput with every mistake of the file and
/// of every case. source: file name, for messages. existing: what has been computed already.
[[nodiscard]] Campaign parse_campaign(const std::string& text, const std::string& source = "campaign",
                                      const ExistingCases& existing = {});
[[nodiscard]] Campaign read_campaign(const std::filesystem::path& file, const ExistingCases& existing = {});

}  // namespace softwall::campaign
