#include "campaign/launch/scratch.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include <xxhash.h>

#include "campaign/system/work_marks.hpp"
#include "solver/case/hexadecimal.hpp"

namespace softwall::campaign {
namespace {

constexpr std::size_t kLongestRoot = 40;  // leaves room for a session path within the 108 bytes of a socket

std::string name_for(const std::filesystem::path& run_directory) {
  const std::string path = canonical_run_directory(run_directory);
  return "softwall-" + std::to_string(getuid()) + "-" + hexadecimal(XXH3_64bits(path.data(), path.size()));
}

/// Free, or a directory that this user has made.
bool is_ours_to_use(const std::filesystem::path& name) {
  struct stat status {};
  if (lstat(name.c_str(), &status) != 0) return errno == ENOENT;
  return S_ISDIR(status.st_mode) && status.st_uid == geteuid();
}

/// The folder is common to all users, and anybody can make a name that he can guess.
std::filesystem::path usable_name(const std::filesystem::path& root, const std::string& name) {
  constexpr int kMostNames = 100;
  for (int i = 0; i < kMostNames; ++i) {
    const auto candidate = root / (i == 0 ? name : name + "-" + std::to_string(i));
    if (is_ours_to_use(candidate)) return candidate;
  }
  return root / name;  // create() says what is wrong
}

void make_private(const std::filesystem::path& directory) {
  // mkdir refuses a name that exists, so nobody else's directory or link is ever used.
  if (mkdir(directory.c_str(), 0700) != 0) {
    throw std::runtime_error("cannot make the temporary directory " + directory.string() + ": " +
                             std::strerror(errno));
  }
}

}  // namespace

std::filesystem::path temporary_root() {
  std::error_code ignored;
  const auto root = std::filesystem::temp_directory_path(ignored);
  // A relative one would be another folder for mpirun, which works in the run directory.
  const bool usable = root.is_absolute() && root.string().size() <= kLongestRoot;
  return usable ? root : std::filesystem::path("/tmp");
}

Scratch::Scratch(const std::filesystem::path& run_directory) {
  const std::string name = name_for(run_directory);
  session_ = usable_name(temporary_root(), name);
  const std::filesystem::path memory = "/dev/shm";
  shared_memory_ = access(memory.c_str(), W_OK) == 0 ? usable_name(memory, name) : session_ / "shm";
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
