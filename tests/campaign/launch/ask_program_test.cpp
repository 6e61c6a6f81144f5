#include "campaign/launch/ask_program.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "campaign/system/clock.hpp"
#include "campaign/system/process_identity.hpp"

namespace softwall::campaign {
namespace {

Answer ask_shell(const std::string& script, double seconds = 20) {
  return ask_program({{"/bin/sh", "-c", script}, {"PATH=/usr/bin:/bin", "WORD=known"}, seconds});
}

TEST(AskProgram, KeepsWhatIsSaidAndWhatIsComplainedAboutApart) {
  const Answer answer = ask_shell("echo said $WORD; echo complained >&2; exit 7");
  EXPECT_EQ(answer.output, "said known\n");
  EXPECT_EQ(answer.errors, "complained\n");
  EXPECT_EQ(answer.exit_code, 7);
}

TEST(AskProgram, TellsASignalAsAShellDoes) { EXPECT_EQ(ask_shell("kill -9 $$").exit_code, 137); }

TEST(AskProgram, EndsWhatTakesTooLongWithAllThatItHasStarted) {
  const double begin = monotonic_seconds();
  const Answer answer = ask_shell("sleep 60 & echo $!; wait", 0.3);
  EXPECT_LT(monotonic_seconds() - begin, 20);
  EXPECT_FALSE(answer.exit_code);
  const auto child = static_cast<pid_t>(std::stoi(answer.output));
  while (!has_ended(child) && monotonic_seconds() - begin < 20)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(has_ended(child));
}

TEST(AskProgram, ALongAnswerDoesNotStopIt) {
  EXPECT_EQ(ask_shell("head -c 3000000 /dev/zero").output.size(), 3'000'000U);
}

TEST(AskProgram, WhatCannotBeStartedSaysWhy) {
  const Answer answer = ask_program({{"/no/such/program"}, {}, 1});
  EXPECT_FALSE(answer.exit_code);
  EXPECT_NE(answer.errors.find("/no/such/program"), std::string::npos) << answer.errors;
}

}  // namespace
}  // namespace softwall::campaign
