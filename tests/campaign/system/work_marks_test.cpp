#include "campaign/system/work_marks.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>

#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {
namespace {

constexpr const char* kWait = "exec sleep 60";
constexpr const char* kBecomeItself = "exec /bin/sh -c \"$0\" \"$0\"";  // again and again

/// A process whose environment, given at exec, names a run directory and a session; 0: the one it leads.
std::function<int()> worker(const std::string& run_directory, pid_t session = 0,
                            const char* command = kWait) {
  return [run_directory, session, command] {
    if (session == 0) setsid();
    setenv(kRunDirectoryVariable, run_directory.c_str(), 1);
    setenv(kSessionVariable, std::to_string(session == 0 ? getpid() : session).c_str(), 1);
    execl("/bin/sh", "sh", "-c", command, command, nullptr);
    return 127;
  };
}

std::vector<pid_t> wait_for_work(const std::filesystem::path& directory) {
  std::vector<pid_t> found;
  for (int i = 0; i < 100 && found.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    found = ProcessesAtWork::look().in(directory);
  }
  return found;
}

/// Until a process names a run directory, as it does from its exec on.
bool wait_for_mark(pid_t pid) {
  for (int i = 0; i < 500; ++i) {
    std::ifstream in("/proc/" + std::to_string(pid) + "/environ");
    const std::string environment{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (environment.find(kRunDirectoryVariable) != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

class WorkMarksTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::filesystem::path directory_ = std::filesystem::canonical(folder_.path()) / "case";
};

TEST_F(WorkMarksTest, FindsExactlyTheProcessesOfARunDirectory) {
  const test::ChildProcess ours(worker(directory_)), neighbour(worker(directory_.string() + "2"));
  EXPECT_EQ(wait_for_work(directory_), std::vector<pid_t>{ours.pid()});
}

TEST_F(WorkMarksTest, LooksIntoChosenSessionsOnly) {
  const test::ChildProcess ours(worker(directory_)), neighbour(worker(directory_.string() + "2"));
  ASSERT_EQ(wait_for_work(directory_), std::vector<pid_t>{ours.pid()});
  ASSERT_EQ(wait_for_work(directory_.string() + "2"), std::vector<pid_t>{neighbour.pid()});
  const auto work = ProcessesAtWork::look_in({ours.pid()});
  EXPECT_EQ(work.in(directory_), std::vector<pid_t>{ours.pid()});
  EXPECT_TRUE(work.in(directory_.string() + "2").empty());
  EXPECT_TRUE(ProcessesAtWork::look_in({}).nobody());
}

/// While it does, it has no environment for a moment.
TEST_F(WorkMarksTest, AProcessThatBecomesAnotherProgramIsFound) {
  const test::ChildProcess ours(worker(directory_, 0, kBecomeItself));
  ASSERT_EQ(wait_for_work(directory_), std::vector<pid_t>{ours.pid()});
  for (int i = 0; i < 1000; ++i)
    ASSERT_EQ(ProcessesAtWork::look_in({ours.pid()}).in(directory_), std::vector<pid_t>{ours.pid()}) << i;
}

TEST_F(WorkMarksTest, APersonsProcessWithTheSameVariablesIsNotTaken) {
  const test::ChildProcess ours(worker(directory_));
  ASSERT_EQ(wait_for_work(directory_), std::vector<pid_t>{ours.pid()});
  const test::ChildProcess copied(worker(directory_, ours.pid()));
  const test::ChildProcess only_the_directory(worker(directory_, 1));
  for (const pid_t pid : {copied.pid(), only_the_directory.pid()}) ASSERT_TRUE(wait_for_mark(pid));
  EXPECT_EQ(ProcessesAtWork::look().in(directory_), std::vector<pid_t>{ours.pid()});
}

TEST_F(WorkMarksTest, ADirectoryIsTheSameBehindALink) {
  std::filesystem::create_directory(directory_);
  std::filesystem::create_symlink(directory_, folder_.path() / "link");
  EXPECT_EQ(run_directory_mark(folder_.path() / "link"), "SOFTWALL_RUN_DIRECTORY=" + directory_.string());
  const test::ChildProcess ours(worker(directory_));
  EXPECT_EQ(wait_for_work(folder_.path() / "link"), std::vector<pid_t>{ours.pid()});
}

}  // namespace
}  // namespace softwall::campaign
