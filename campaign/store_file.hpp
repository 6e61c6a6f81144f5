#pragma once

#include <filesystem>

#include "campaign/file_system.hpp"
#include "campaign/sqlite.hpp"
#include "campaign/store.hpp"

/// From a campaign directory to an open, checked results.db.
namespace softwall::campaign {

/// results.db of a campaign directory, opened as asked, of the present format and set up for safe writing.
/// Throws SqliteError; a file that is refused is left as it was.
[[nodiscard]] Connection open_store_file(const std::filesystem::path& campaign_directory, OpenMode mode);

/// Journal, synchronisation and foreign keys of a connection that writes.
void set_up_for_writing(Connection& connection, JournalMode journal);

}  // namespace softwall::campaign
