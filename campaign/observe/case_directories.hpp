#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>

#include "campaign/core/campaign.hpp"
#include "campaign/core/existing_cases.hpp"

/// The run directories that a campaign's folder holds, by their names "cases/<label>-<first 8 of the id>".
namespace softwall::campaign {

/// Directory by the digits of the id in its name.
using CaseDirectories = std::unordered_multimap<std::string, std::string>;

/// Every run directory that is there.
[[nodiscard]] CaseDirectories existing_directories(const std::filesystem::path& folder);

/// The cases that have those run directories: the campaign's own, as it reads by itself, which nothing may
/// displace, and all others with a readable case file. Empty when every case of the campaign has its
/// directory.
[[nodiscard]] ExistingCases existing_cases(const Campaign& campaign, const std::filesystem::path& folder,
                                           const CaseDirectories& directories);

}  // namespace softwall::campaign
