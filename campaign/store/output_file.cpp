#include "campaign/store/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "solver/case/atomic_file.hpp"
#include "solver/case/file_descriptor.hpp"

namespace softwall::campaign {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file) {
  throw std::system_error(errno, std::generic_category(), file.string() + ": cannot write");
}

/// Into what is there already.
void write_through(const fs::path& file, std::string_view contents) {
  FileDescriptor out(open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC | O_NOCTTY));
  if (!out) fail(file);
  while (!contents.empty()) {
    const ssize_t written = write(out.get(), contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(file);
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  if (!out.close()) fail(file);
}

/// The file that a chain of links leads to, whether it is there yet or not.
fs::path behind_links(fs::path file) {
  constexpr int kLongestChain = 40;  // as the kernel
  std::error_code unknown;
  for (int i = 0; i < kLongestChain && fs::is_symlink(file, unknown); ++i)
    file = file.parent_path() / fs::read_symlink(file, unknown);
  return file;
}

}  // namespace

void write_output(const fs::path& named, std::string_view contents) {
  std::error_code unknown;
  const fs::path file = behind_links(named);
  const fs::file_status status = fs::status(file, unknown);
  if (!fs::exists(status)) return write_atomically(file, contents);
  if (fs::is_directory(status)) {
    errno = EISDIR;
    fail(file);
  }
  const bool plain = fs::is_regular_file(status) && fs::hard_link_count(file, unknown) == 1;
  if (!plain) return write_through(file, contents);
  if (access(file.c_str(), W_OK) != 0) fail(file);  // a new file in its place would pass the protection over
  write_atomically(file, contents);
  fs::permissions(file, status.permissions(), unknown);
}

}  // namespace softwall::campaign
