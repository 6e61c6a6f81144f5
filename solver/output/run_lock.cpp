#include "solver/output/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include "solver/output/agree.hpp"

namespace softwall::output {

namespace {

using namespace std::chrono_literals;

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

FileDescriptor lock(const std::filesystem::path& file) {
  // Whoever can open it can lock it: for this user only, and never what a link of that name leads to.
  FileDescriptor descriptor(
      ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR));
  if (!descriptor) fail("cannot open " + file.string());
  const auto deadline = std::chrono::steady_clock::now() + 5s;
  while (::flock(descriptor.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) fail("cannot lock " + file.string());
    if (std::chrono::steady_clock::now() > deadline) {
      throw AgreedError(ExitCode::kFailed, "another solver is running in " + file.parent_path().string() +
                                               " (it holds " + file.filename().string() + ")");
    }
    std::this_thread::sleep_for(50ms);
  }
  return descriptor;
}

}  // namespace

RunLock::RunLock(const RunFiles& run, const parallel::Communicator& all) {
  agree_on_root(all, ExitCode::kFailed, [&] { descriptor_ = lock(run.lock()); });
}

}  // namespace softwall::output
