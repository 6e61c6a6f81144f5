#include "campaign/store/backup.hpp"

#include <sqlite3.h>
#include <unistd.h>

#include <memory>
#include <string>

#include "solver/case/atomic_file.hpp"

namespace softwall::campaign {

namespace {

constexpr int kAllPages = -1;

}  // namespace

/// A store is small, and the copy then reaches the disk in one publication.
Connection copy_in_memory(Connection& source) {
  Connection copy = Connection::open_in_memory();
  sqlite3_backup* backup = sqlite3_backup_init(copy.handle(), "main", source.handle(), "main");
  if (backup == nullptr) source.fail("cannot back up", sqlite3_extended_errcode(copy.handle()));
  const int stepped = sqlite3_backup_step(backup, kAllPages);
  const int finished = sqlite3_backup_finish(backup);
  if (stepped != SQLITE_DONE) source.fail("cannot back up", finished != SQLITE_OK ? finished : stepped);
  return copy;
}

void backup_connection(Connection& connection, const std::filesystem::path& destination) {
  Connection copy = copy_in_memory(connection);
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> bytes(
      sqlite3_serialize(copy.handle(), "main", &size, 0), sqlite3_free);
  if (bytes == nullptr) copy.fail("cannot back up", SQLITE_NOMEM);
  // The header says "write-ahead log" when the source used one; a lone file must not need its companions.
  if (size > 19) bytes.get()[18] = bytes.get()[19] = 1;
  if (!write_new_atomically(destination,
                            {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)})) {
    throw SqliteError(destination.string() + ": exists already; a backup replaces no file", 0);
  }
}

}  // namespace softwall::campaign
