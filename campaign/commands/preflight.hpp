#pragma once

#include <filesystem>

#include "campaign/core/campaign.hpp"

/// What must be right before anything is changed. Each failure throws BadInput with one clear message.
namespace softwall::campaign {

/// softwall-dns: $SOFTWALL_DNS, or beside softwall itself.
[[nodiscard]] std::filesystem::path find_solver();

/// The solver of every precision that the campaign's cases ask for stands beside `solver`.
void require_precisions(const Campaign& campaign, const std::filesystem::path& solver);

/// A file can be made in the campaign's folder.
void require_writable(const std::filesystem::path& folder);

/// The checkpoints that unfinished cases will write fit on the disk.
void require_disk_space(const Campaign& campaign, const std::filesystem::path& folder);

}  // namespace softwall::campaign
