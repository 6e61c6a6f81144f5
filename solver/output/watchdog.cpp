#include "solver/output/watchdog.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <string_view>

#include "solver/run_directory/exit_codes.hpp"

namespace softwall::output {

namespace {

extern "C" void give_up(int) {
  constexpr std::string_view kMessage =
      "softwall-dns: file input or output hangs, giving up; the last checkpoint is intact\n";
  static_cast<void>(!::write(STDERR_FILENO, kMessage.data(), kMessage.size()));
  ::_exit(static_cast<int>(ExitCode::kIoFailure));
}

}  // namespace

Watchdog::Watchdog(unsigned seconds) {
  struct sigaction action {};
  action.sa_handler = give_up;
  ::sigaction(SIGALRM, &action, nullptr);
  ::alarm(seconds);
}

Watchdog::~Watchdog() { ::alarm(0); }

unsigned Watchdog::seconds_for(std::int64_t bytes) {
  constexpr std::int64_t kLeast = 120, kMost = 86400, kBytesPerSecond = 5'000'000;
  return static_cast<unsigned>(std::min(kMost, kLeast + bytes / kBytesPerSecond));
}

}  // namespace softwall::output
