#pragma once

#include <filesystem>

#include "campaign/sqlite.hpp"

/// Consistent copies of the store, also while the manager writes it (cp is not safe then). A copy appears
/// under its name only when complete and on disk; an existing file is refused. Throws SqliteError or
/// std::system_error.
namespace softwall::campaign {

void backup_store(const std::filesystem::path& campaign_directory, const std::filesystem::path& destination);

/// Of an open database.
void backup_connection(Connection& connection, const std::filesystem::path& destination);

}  // namespace softwall::campaign
