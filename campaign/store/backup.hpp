#pragma once

#include <filesystem>

#include "campaign/store/sqlite.hpp"

namespace softwall::campaign {

/// All of an open database, in memory.
[[nodiscard]] Connection copy_in_memory(Connection& source);

/// A consistent copy of an open database, also while another connection writes it (cp is not safe then). The
/// copy appears under its name only when it is complete and on disk; an existing file is refused. Throws
/// SqliteError or std::system_error.
void backup_connection(Connection& connection, const std::filesystem::path& destination);

}  // namespace softwall::campaign
