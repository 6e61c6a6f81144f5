#include "campaign/store/store_file.hpp"

#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "campaign/store/backup.hpp"
#include "campaign/store/store_schema.hpp"
#include "solver/case/atomic_file.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {

namespace {

using std::filesystem::path;

/// code: SQLITE_CORRUPT where the store has to be made again, 0 where that would not help.
[[noreturn]] void refuse(const path& file, const std::string& why, int code = 0) {
  throw SqliteError(file.string() + ": " + why, code);
}

path beside(const path& file, const char* suffix) {
  path result = file;
  result += suffix;
  return result;
}

/// A change begun by a program that died, kept by SQLite beside the store until somebody may write.
bool has_unfinished_change(const path& file) {
  for (const char* suffix : {"-wal", "-journal"}) {
    std::error_code absent;
    const auto size = std::filesystem::file_size(beside(file, suffix), absent);
    if (!absent && size > 0) return true;
  }
  return false;
}

/// Made in memory and published whole: a crash leaves no half-made store behind.
void create(const path& file) {
  // Asked in this order: a program that has just made the store has its file there before its log.
  if (has_unfinished_change(file) && !std::filesystem::exists(file)) {
    refuse(
        file,
        "is gone, but its -wal or -journal file is still there: put it back from a backup, or make it again "
        "from the run directories",
        SQLITE_CORRUPT);
  }
  Connection made = Connection::open_in_memory();
  create_schema(made);
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> bytes(
      sqlite3_serialize(made.handle(), "main", &size, 0), sqlite3_free);
  if (bytes == nullptr) refuse(file, "out of memory");
  try {
    // False means that another program was faster: its store is as good.
    (void)write_new_atomically(file,
                               {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)});
  } catch (const std::system_error& error) {
    refuse(file, std::string("cannot create the results store: ") + error.what());
  }
}

/// What can be seen without opening: for SQLite, a file without even a first page is an empty database, and a
/// page without its end is whole.
void check_file(const path& file) {
  if (!std::filesystem::is_regular_file(file)) refuse(file, "is not a file");
  constexpr std::uintmax_t kSmallestPage = 512;
  const auto size = std::filesystem::file_size(file);
  if (size < kSmallestPage) {
    refuse(file,
           (size == 0 ? "is empty (0 bytes)" : "holds nothing (" + std::to_string(size) + " bytes)") +
               std::string(" and is no results store: restore a backup, or make it again from the run "
                           "directories"),
           SQLITE_CORRUPT);
  }
  // SQLite fills up what is missing of the last page, where the text of some row may have stood.
  if (size % kSmallestPage != 0 && !has_unfinished_change(file)) {
    refuse(file,
           "is damaged: cut off within a page (" + std::to_string(size) +
               " bytes); restore a backup, or make it again from the run directories",
           SQLITE_CORRUPT);
  }
}

void set_checkpoint_on_close(Connection& connection, bool on) {
  sqlite3_db_config(connection.handle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, on ? 0 : 1, nullptr);
}

void check_health(Connection& connection) {
  Statement check = connection.prepare("PRAGMA quick_check(1)");
  const std::string answer = check.step() ? check.text(0) : "no answer";
  if (answer != "ok") {
    refuse(connection.file(),
           "is damaged: " + answer + ": restore a backup, or make it again from the run directories",
           SQLITE_CORRUPT);
  }
}

void bring_up_to_date(Connection& connection, int version) {
  if (version == kSchemaVersion) return;
  const path saved = beside(connection.file(), (".format-" + std::to_string(version)).c_str());
  if (!std::filesystem::exists(saved)) backup_connection(connection, saved);
  migrate(connection, migrations(), kSchemaVersion);
}

Connection open_for_writing(const path& file) {
  Connection connection = Connection::open(file, Access::kReadWrite);
  // A foreign database must not even have its write-ahead log folded in.
  set_checkpoint_on_close(connection, false);
  if (sqlite3_db_readonly(connection.handle(), "main") != 0) refuse(file, "is write-protected");
  const int version = schema_version(connection);
  check_health(connection);
  set_checkpoint_on_close(connection, true);
  set_up_for_writing(connection, journal_mode_for(file));
  bring_up_to_date(connection, version);
  return connection;
}

/// A rollback journal left by a crash must be played back before anybody can read; only a writer can.
void recover(const path& file) {
  (void)Connection::open(file, Access::kReadWrite).integer("PRAGMA user_version");
}

/// The store in a place where we may not write: SQLite cannot make the files by which readers and writers
/// meet.
Connection open_immutable(const path& file) {
  if (has_unfinished_change(file)) {
    refuse(file,
           "holds a change that has to be completed first, and this place cannot be written: copy the whole "
           "folder elsewhere, or open it once as its owner");
  }
  return Connection::open(file, Access::kReadOnly, true);
}

bool is_about_writing(const SqliteError& error) {
  return error.primary_code() == SQLITE_READONLY || error.primary_code() == SQLITE_CANTOPEN;
}

/// A reader may not change a store of an earlier format, so it reads a copy that is brought up to date.
Connection of_present_format(Connection connection) {
  if (schema_version(connection) == kSchemaVersion) return connection;
  Connection copy = copy_in_memory(connection);
  migrate(copy, migrations(), kSchemaVersion);
  return copy;
}

Connection open_for_reading(const path& file) {
  Connection connection = Connection::open(file, Access::kReadOnly);
  try {
    (void)schema_version(connection);
  } catch (const SqliteError& error) {
    if (!is_about_writing(error)) throw;
    if (error.code() == SQLITE_READONLY_ROLLBACK && ::access(file.c_str(), W_OK) == 0) {
      recover(file);
      connection = Connection::open(file, Access::kReadOnly);
    } else {
      connection = open_immutable(file);
    }
  }
  return of_present_format(std::move(connection));
}

}  // namespace

void set_up_for_writing(Connection& connection, JournalMode journal) {
  const bool log = journal == JournalMode::kWriteAheadLog;
  connection.run(log ? "PRAGMA journal_mode = WAL" : "PRAGMA journal_mode = DELETE");
  // EXTRA adds to FULL that the removal of the rollback journal, which is the commit, is on disk too.
  connection.run(log ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = EXTRA");
  connection.run("PRAGMA foreign_keys = ON");
}

path store_path(const path& campaign_directory) { return campaign_directory / "results.db"; }

void sweep_unfinished_stores(const path& campaign_directory) {
  const std::string temporary = "." + store_path(campaign_directory).filename().string() + ".tmp-";
  std::error_code ignored;  // a file that stays does no harm
  for (const auto& entry : std::filesystem::directory_iterator(campaign_directory, ignored)) {
    const std::string name = entry.path().filename();
    if (name.starts_with(temporary) || name.starts_with(kRebuildFolder))
      std::filesystem::remove_all(entry.path(), ignored);
  }
}

path set_store_aside(const path& campaign_directory) {
  const path file = store_path(campaign_directory);
  std::string time = utc_now();
  std::ranges::replace(time, ':', '-');
  const path old = beside(file, ("." + time).c_str());
  bool any = false;
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) {
    const path part = beside(file, suffix);
    if (!std::filesystem::exists(std::filesystem::symlink_status(part))) continue;
    std::filesystem::rename(part, beside(old, suffix));
    any = true;
  }
  return any ? old : path();
}

Connection open_store_file(const path& campaign_directory, OpenMode mode) {
  const path file = store_path(campaign_directory);
  if (!std::filesystem::is_directory(campaign_directory))
    refuse(campaign_directory, "no such campaign directory");
  if (!std::filesystem::exists(std::filesystem::symlink_status(file))) {
    if (mode != OpenMode::kCreate) refuse(file, "no results store here: has this campaign been run?");
    create(file);
  }
  check_file(file);
  return mode == OpenMode::kReadOnly ? open_for_reading(file) : open_for_writing(file);
}

}  // namespace softwall::campaign
