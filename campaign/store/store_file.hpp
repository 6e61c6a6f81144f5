#pragma once

#include <filesystem>

#include "campaign/store/sqlite.hpp"
#include "campaign/system/file_system.hpp"

/// Finds, checks and opens the results.db of a campaign directory.
namespace softwall::campaign {

/// kCreate makes a new store where there is none and opens an existing one like kReadWrite.
/// A file that is there but is no store of this program is refused in every mode and never touched.
enum class OpenMode { kCreate, kReadWrite, kReadOnly };

/// results.db of a campaign directory, whether it exists or not.
[[nodiscard]] std::filesystem::path store_path(const std::filesystem::path& campaign_directory);

/// results.db of a campaign directory, opened as asked, of the present format and set up for safe writing.
/// Throws SqliteError; a file that is refused is left as it was.
[[nodiscard]] Connection open_store_file(const std::filesystem::path& campaign_directory, OpenMode mode);

/// Where a new store is made beside an old one that it is to replace: a folder, whose name begins so.
inline constexpr const char* kRebuildFolder = ".softwall-rebuild-";

/// Removes what is left of stores whose maker was killed. Only while nobody else can make one.
void sweep_unfinished_stores(const std::filesystem::path& campaign_directory);

/// Renames results.db of a campaign directory, with the files that SQLite may keep beside it: out of the way,
/// never removed. Its new name; empty where there was none.
std::filesystem::path set_store_aside(const std::filesystem::path& campaign_directory);

/// Journal, synchronisation and foreign keys of a connection that writes.
void set_up_for_writing(Connection& connection, JournalMode journal);

}  // namespace softwall::campaign
