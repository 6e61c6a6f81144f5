#include "solver/case/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "solver/case/file_descriptor.hpp"

namespace softwall {
namespace {

[[noreturn]] void fail(const char* step, const std::filesystem::path& path) {
  throw std::system_error(errno, std::generic_category(),
                          std::string("cannot ") + step + " " + path.string());
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// A file that some library has written.
struct OfAnother {
  std::filesystem::path path;
};

/// Removes the temporary file unless it has become the real one.
class TemporaryFile {
 public:
  explicit TemporaryFile(OfAnother file) : path_(std::move(file.path)) {}
  explicit TemporaryFile(const std::filesystem::path& final_name) {
    static std::atomic<unsigned> counter{0};  // two threads of one process may write the same file
    path_ = folder_of(final_name) / ("." + final_name.filename().string() + ".tmp-" +
                                     std::to_string(::getpid()) + "-" + std::to_string(counter++));
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void release() { path_.clear(); }

 private:
  std::filesystem::path path_;
};

/// Puts complete, synced contents under the temporary name.
void fill(const TemporaryFile& temporary, std::string_view contents, bool synced) {
  const auto& name = temporary.path();
  // A leftover of a killed process that had the same id is ours to overwrite: no one else uses this name.
  FileDescriptor descriptor(
      ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (!descriptor) fail("create", name);
  write_all(descriptor.get(), contents, name);
  if (synced && ::fsync(descriptor.get()) != 0) fail("sync", name);
  if (!descriptor.close()) fail("close", name);
}

/// Gives the file a second name; false when that is taken. link(2), unlike rename(2), fails then.
bool link_as_new(const std::filesystem::path& source, const std::filesystem::path& file) {
  if (::link(source.c_str(), file.c_str()) == 0) return true;
  if (errno == EEXIST) return false;
  if (errno != EPERM && errno != ENOTSUP && errno != ENOSYS) fail("create", file);
  // A file system without hard links: nearly as good, since one manager owns a campaign.
  if (std::filesystem::exists(file)) return false;
  if (::rename(source.c_str(), file.c_str()) != 0) fail("create", file);
  return true;
}

}  // namespace

void write_all(int descriptor, std::string_view contents, const std::filesystem::path& path) {
  while (!contents.empty()) {
    const ssize_t count = ::write(descriptor, contents.data(), contents.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("write", path);
    contents.remove_prefix(static_cast<std::size_t>(count));
  }
}

bool is_trouble_of_disk(const std::error_code& error) {
  switch (error.default_error_condition().value()) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
    case EIO:
    case EROFS:
      return true;
    default:
      return false;
  }
}

void sync_directory(const std::filesystem::path& directory) {
  const FileDescriptor folder(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder) fail("open the folder", directory);
  if (::fsync(folder.get()) != 0) fail("sync the folder", directory);
}

void sync_file(const std::filesystem::path& file) {
  const FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor) fail("open", file);
  if (::fsync(descriptor.get()) != 0) fail("sync", file);
  sync_directory(folder_of(file));
}

void write_atomically(const std::filesystem::path& file, std::string_view contents, Durability durability) {
  const bool synced = durability == Durability::kSynced;
  TemporaryFile temporary(file);
  fill(temporary, contents, synced);
  if (::rename(temporary.path().c_str(), file.c_str()) != 0) fail("replace", file);
  temporary.release();
  if (synced) sync_directory(folder_of(file));
}

bool write_new_atomically(const std::filesystem::path& file, std::string_view contents) {
  const TemporaryFile temporary(file);
  fill(temporary, contents, true);
  if (!link_as_new(temporary.path(), file)) return false;
  sync_directory(folder_of(file));
  return true;
}

void begin_write_out(int descriptor) {
  static_cast<void>(::sync_file_range(descriptor, 0, 0 /* to its end */, SYNC_FILE_RANGE_WRITE));
}

void publish_file(const std::filesystem::path& temporary, const std::filesystem::path& file) {
  TemporaryFile unpublished{OfAnother{temporary}};
  const FileDescriptor descriptor(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor) fail("open", temporary);
  if (::fsync(descriptor.get()) != 0) fail("sync", temporary);
  if (::rename(temporary.c_str(), file.c_str()) != 0) fail("replace", file);
  unpublished.release();
  sync_directory(folder_of(file));
}

}  // namespace softwall
