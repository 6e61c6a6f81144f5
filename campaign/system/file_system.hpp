#pragma once

#include <filesystem>
#include <string>

namespace softwall::campaign {

enum class JournalMode {
  kWriteAheadLog,  ///< readers and the writer do not wait for each other; needs shared memory: local disks
                   ///< only
  kRollback,       ///< works wherever file locks do
};

/// The journal for a file system of the type that statfs(2) names. Only file systems known to be local get
/// the write-ahead log: a network file system we have not heard of, FUSE or an overlay of unknown layers
/// would otherwise damage the store in silence.
[[nodiscard]] JournalMode journal_mode_for_type(long file_system_type);

/// The journal for the file system that holds path. Throws std::system_error when it cannot be asked.
[[nodiscard]] JournalMode journal_mode_for(const std::filesystem::path& path);

/// When the file system last changed anything about a file or folder, UTC text in milliseconds: a time that
/// nobody can set, unlike that of modification. Empty when it is not there.
[[nodiscard]] std::string change_time(const std::filesystem::path& path);

enum class LockState {
  kFree,    ///< also where there is no such file
  kHeld,    ///< by any process
  kUnknown  ///< nobody here may ask: the file belongs to another user
};
/// Of the lock (flock) of a file.
[[nodiscard]] LockState lock_state(const std::filesystem::path& file);
[[nodiscard]] bool lock_is_held(const std::filesystem::path& file);

}  // namespace softwall::campaign
