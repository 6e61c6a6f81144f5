#include "campaign/launch/ask_program.hpp"

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "campaign/launch/start_program.hpp"
#include "campaign/system/clock.hpp"
#include "solver/case/file_descriptor.hpp"

namespace softwall::campaign {
namespace {

/// A file in memory that a program writes and we read: no pipe that could fill up while we wait.
class Ear {
 public:
  Ear() : file_(memfd_create("softwall", MFD_CLOEXEC)) {
    if (!file_)
      throw std::runtime_error(std::string("cannot make a file in memory: ") + std::strerror(errno));
  }
  [[nodiscard]] std::string name() const { return "/proc/self/fd/" + std::to_string(file_.get()); }
  [[nodiscard]] std::string heard() const {
    constexpr std::size_t kMost = 64U << 20U;  // ten times what a queue of 100,000 jobs fills
    std::string text;
    std::array<char, 65536> piece;
    while (text.size() < kMost) {
      const ssize_t length = pread(file_.get(), piece.data(), piece.size(), static_cast<off_t>(text.size()));
      if (length <= 0) break;
      text.append(piece.data(), static_cast<std::size_t>(length));
    }
    return text;
  }

 private:
  FileDescriptor file_;
};

/// The wait status of a child that ends in time. One that does not is killed.
std::optional<int> wait_for(pid_t child, double seconds) {
  const double end = monotonic_seconds() + seconds;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (monotonic_seconds() > end) {
      kill(-child, SIGKILL);  // with what it has started: it leads a group of its own
      waitpid(child, &status, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return status;
}

}  // namespace

Answer ask_program(const Question& question) {
  try {
    const Ear output, errors;
    const pid_t child =
        start_program({question.arguments, question.environment, "/", output.name(), errors.name()});
    const auto status = wait_for(child, question.seconds);
    Answer answer{output.heard(), errors.heard(), std::nullopt};
    if (status) answer.exit_code = exit_code_of(*status);
    return answer;
  } catch (const std::runtime_error& error) {
    return {"", error.what(), std::nullopt};
  }
}

}  // namespace softwall::campaign
