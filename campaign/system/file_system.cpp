#include "campaign/system/file_system.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <string>
#include <system_error>

#include "solver/case/file_descriptor.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {

namespace {

/// From statfs(2) and linux/magic.h; numbers because not every libc names them all.
constexpr std::array<long, 9> kLocalTypes = {
    0xEF53,      // ext2, ext3, ext4
    0x58465342,  // XFS
    0x9123683E,  // Btrfs
    0x01021994,  // tmpfs
    0x858458F6,  // ramfs
    0x2FC12FC1,  // ZFS
    0xF2F52010,  // F2FS
    0x3153464A,  // JFS
    0xCA451A4E,  // bcachefs
};

}  // namespace

JournalMode journal_mode_for_type(long file_system_type) {
  const bool local = std::find(kLocalTypes.begin(), kLocalTypes.end(), file_system_type) != kLocalTypes.end();
  return local ? JournalMode::kWriteAheadLog : JournalMode::kRollback;
}

JournalMode journal_mode_for(const std::filesystem::path& path) {
  struct statfs answer {};
  if (::statfs(path.c_str(), &answer) != 0) {
    throw std::system_error(errno, std::generic_category(),
                            path.string() + ": cannot ask for the file system");
  }
  return journal_mode_for_type(static_cast<long>(answer.f_type));
}

std::string change_time(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return "";
  const auto since_1970 =
      std::chrono::seconds(status.st_ctim.tv_sec) + std::chrono::nanoseconds(status.st_ctim.tv_nsec);
  return utc_text(std::chrono::floor<std::chrono::milliseconds>(since_1970));
}

LockState lock_state(const std::filesystem::path& file) {
  const FileDescriptor lock(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (!lock) return errno == EACCES ? LockState::kUnknown : LockState::kFree;
  const bool held = flock(lock.get(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  return held ? LockState::kHeld : LockState::kFree;
}

bool lock_is_held(const std::filesystem::path& file) { return lock_state(file) == LockState::kHeld; }

}  // namespace softwall::campaign
