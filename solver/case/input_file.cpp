#include "solver/case/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "solver/case/bad_input.hpp"
#include "solver/case/file_descriptor.hpp"

namespace softwall {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw BadInput(path.string(), {{"", why, ""}});
}

}  // namespace

std::string read_input_file(const std::filesystem::path& path, std::size_t limit) {
  // O_NONBLOCK: opening a FIFO that nobody writes to returns at once, and fstat then tells what it is.
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file) refuse(path, std::string("cannot be opened: ") + std::strerror(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0)
    refuse(path, std::string("cannot be examined: ") + std::strerror(errno));
  if (!S_ISREG(status.st_mode))
    refuse(path, S_ISDIR(status.st_mode) ? "is a directory, not a file" : "is not a regular file");

  std::string text;
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(path, std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (text.size() > limit) refuse(path, "is larger than " + std::to_string(limit >> 20) + " MiB");
  }
}

}  // namespace softwall
