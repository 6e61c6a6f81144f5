#include "campaign/launch/scratch.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include <xxhash.h>

#include "solver/case/hexadecimal.hpp"

namespace softwall::campaign {
namespace {

constexpr std::size_t kLongestRoot = 40;  // leaves room for a session path within the 108 bytes of a socket

std::filesystem::path temporary_root() {
  std::error_code ignored;
  const auto root = std::filesystem::temp_directory_path(ignored);
  return !root.empty() && root.string().size() <= kLongestRoot ? root : std::filesystem::path("/tmp");
}

std::string name_for(const std::filesystem::path& run_directory) {
  const std::string path = std::filesystem::weakly_canonical(run_directory);
  return "softwall-" + std::to_string(getuid()) + "-" + hexadecimal(XXH3_64bits(path.data(), path.size()));
}

void make_private(const std::filesystem::path& directory) {
  // mkdir refuses a name that exists, so nobody else's directory or link is ever used.
  if (mkdir(directory.c_str(), 0700) != 0) {
    throw std::runtime_error("cannot make the temporary directory " + directory.string() + ": " +
                             std::strerror(errno));
  }
}

}  // namespace

Scratch::Scratch(const std::filesystem::path& run_directory) {
  const std::string name = name_for(run_directory);
  session_ = temporary_root() / name;
  const std::filesystem::path memory = "/dev/shm";
  shared_memory_ = access(memory.c_str(), W_OK) == 0 ? memory / name : session_ / "shm";
}

void Scratch::create() const {
  remove();
  make_private(session_);
  make_private(shared_memory_);
}

void Scratch::remove() const {
  std::error_code ignored;
  std::filesystem::remove_all(shared_memory_, ignored);
  std::filesystem::remove_all(session_, ignored);
}

}  // namespace softwall::campaign
