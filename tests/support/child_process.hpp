#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

namespace softwall::test {

/// A child that runs `work` and ends with what it returns; killed and waited for at the end of the test.
class ChildProcess {
 public:
  explicit ChildProcess(const std::function<int()>& work) : pid_(fork()) {
    if (pid_ == 0) _exit(work());
  }
  ~ChildProcess() {
    send(SIGKILL);
    if (!waited_) wait();
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  void send(int signal) const {
    if (!waited_) kill(pid_, signal);
  }
  /// The wait status.
  int wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    waited_ = true;
    return status;
  }

 private:
  pid_t pid_;
  bool waited_ = false;
};

}  // namespace softwall::test
