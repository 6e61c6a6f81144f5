#include "campaign/system/file_system.hpp"

#include <fcntl.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <system_error>

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

class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& attempted) {
  throw std::system_error(errno, std::generic_category(), file.string() + ": " + attempted);
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

void write_and_sync(const std::filesystem::path& file, const char* bytes, std::size_t size) {
  const FileDescriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (out.number() < 0) fail(file, "cannot create");
  while (size > 0) {
    const ssize_t written = ::write(out.number(), bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(file, "cannot write");
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  if (::fsync(out.number()) != 0) fail(file, "cannot sync");
}

void sync_folder(const std::filesystem::path& folder) {
  const FileDescriptor handle(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (handle.number() < 0 || ::fsync(handle.number()) != 0) fail(folder, "cannot sync");
}

/// 0, or the errno; EEXIST when the name is taken.
int rename_as_new(const std::filesystem::path& source, const std::filesystem::path& file) {
  // link(2), unlike rename(2), fails when the name is taken.
  if (::link(source.c_str(), file.c_str()) == 0) return 0;
  if (errno != EPERM && errno != ENOTSUP && errno != ENOSYS) return errno;
  // A file system without hard links: nearly as good, since one manager owns a campaign.
  if (std::filesystem::exists(file)) return EEXIST;
  return ::rename(source.c_str(), file.c_str()) == 0 ? 0 : errno;
}

}  // namespace

JournalMode journal_mode_for_type(long file_system_type) {
  const bool local = std::find(kLocalTypes.begin(), kLocalTypes.end(), file_system_type) != kLocalTypes.end();
  return local ? JournalMode::kWriteAheadLog : JournalMode::kRollback;
}

JournalMode journal_mode_for(const std::filesystem::path& path) {
  struct statfs answer {};
  if (::statfs(path.c_str(), &answer) != 0) fail(path, "cannot ask for the file system");
  return journal_mode_for_type(static_cast<long>(answer.f_type));
}

bool publish_as_new(const std::filesystem::path& source, const std::filesystem::path& file) {
  const int error = rename_as_new(source, file);
  std::error_code ignored;
  std::filesystem::remove(source, ignored);
  if (error == EEXIST) return false;
  if (error != 0) {
    errno = error;
    fail(file, "cannot create");
  }
  sync_folder(folder_of(file));
  return true;
}

bool publish_new_file(const std::filesystem::path& file, const void* bytes, std::size_t size) {
  std::filesystem::path temporary = file;
  temporary += ".new." + std::to_string(::getpid());
  try {
    write_and_sync(temporary, static_cast<const char*>(bytes), size);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
  return publish_as_new(temporary, file);
}

}  // namespace softwall::campaign
