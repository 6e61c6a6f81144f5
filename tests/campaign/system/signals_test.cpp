#include "campaign/system/signals.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/child_process.hpp"

namespace softwall::campaign {
namespace {

/// How often the user asked to stop, as a process sees it that sends `signal` to itself.
int requests_after(int signal, void (*before)(int)) {
  test::ChildProcess child([=] {
    std::signal(signal, before);
    Signals signals;
    raise(signal);
    signals.wait(std::chrono::milliseconds(10));
    return signals.stop_requests();
  });
  return WEXITSTATUS(child.wait());
}

TEST(Signals, ARequestToStopIsCounted) {
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) EXPECT_EQ(requests_after(signal, SIG_DFL), 1) << signal;
}

TEST(Signals, WhatWasIgnoredAtTheStartStaysIgnored) {
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) EXPECT_EQ(requests_after(signal, SIG_IGN), 0) << signal;
}

TEST(Signals, TheEndOfAChildIsHeardOfAlthoughSigchldWasIgnored) {
  test::ChildProcess program([] {
    std::signal(SIGCHLD, SIG_IGN);
    begin_with_signals();
    const pid_t child = fork();
    if (child == 0) _exit(7);
    int status = 0;
    return waitpid(child, &status, 0) == child ? WEXITSTATUS(status) : 1;
  });
  EXPECT_EQ(WEXITSTATUS(program.wait()), 7);
}

}  // namespace
}  // namespace softwall::campaign
