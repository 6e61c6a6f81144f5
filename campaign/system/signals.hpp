#pragma once

#include <csignal>

#include <chrono>

namespace softwall::campaign {

/// While it lives, SIGINT, SIGTERM, SIGHUP and SIGCHLD do not interrupt the program but wait to be taken
/// here, so that no signal arrives in the middle of a step of the runner. One of the first three that was
/// ignored before stays ignored (nohup). SIGPIPE is ignored: a closed terminal or pipe must not end a
/// campaign.
class Signals {
 public:
  Signals();
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// Sleep until a signal arrives or the time is over; then take all that wait.
  void wait(std::chrono::milliseconds limit);

  /// How often the user asked to stop: 1 checkpoint and end, 2 end quickly, 3 end now.
  [[nodiscard]] int stop_requests() const { return stop_requests_; }

 private:
  sigset_t taken_{};
  sigset_t mask_before_{};
  struct sigaction pipe_before_ {};
  int stop_requests_ = 0;
};

/// At the start of the program. Where SIGCHLD is ignored, as one may inherit it, the kernel forgets a child
/// as soon as it ends, and nobody can be told how it ended. And a file that would exceed the limit of the
/// shell (ulimit -f) is to be an error that can be told, not the end.
void begin_with_signals();

/// In a child between fork and exec: give it the signal handling of a fresh process.
void restore_default_signals();

}  // namespace softwall::campaign
