#include "campaign/launch/process_launcher.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "campaign/launch/scratch.hpp"
#include "campaign/system/clock.hpp"
#include "campaign/system/work_marks.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/run_directory/exit_codes.hpp"
#include "solver/run_directory/run_files.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

/// The launcher with small shell programs in the place of mpirun; the end-to-end tests use the real one.
namespace softwall::campaign {
namespace {

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

bool wait_until(const std::function<bool()>& condition, double seconds = 20) {
  const double end = monotonic_seconds() + seconds;
  while (!condition()) {
    if (monotonic_seconds() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

class ProcessLauncherTest : public ::testing::Test {
 protected:
  /// A launcher whose mpirun is a script with this body.
  ProcessLauncher launcher_with(const std::string& body) {
    return ProcessLauncher({folder_.write_script("mpirun", body), "/opt/softwall dns"});
  }
  LaunchRequest request(const std::string& name = "case one") {
    std::filesystem::create_directories(folder_.path() / name);
    return {"0123456789abcdef", folder_.path() / name, 3, 1, std::nullopt};
  }
  std::optional<EndedAttempt> wait_for_end(ProcessLauncher& launcher, double seconds = 20) {
    std::optional<EndedAttempt> ended;
    wait_until(
        [&] {
          for (const auto& attempt : launcher.collect()) ended = attempt;
          return ended.has_value();
        },
        seconds);
    return ended;
  }
  std::string log(const std::string& name = "case one") {
    return read_text(RunFiles{folder_.path() / name}.log());
  }

  test::TemporaryFolder folder_;
};

TEST_F(ProcessLauncherTest, HandsOverArgumentsWithoutAShell) {
  auto launcher = launcher_with("for a in \"$@\"; do echo \"[$a]\"; done; exit 85");
  auto what = request("$(touch pwned); 'x'");
  what.wall_seconds = 90.7;
  (void)launcher.start(what);
  const auto ended = wait_for_end(launcher);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit_code, static_cast<int>(ExitCode::kInterrupted));
  EXPECT_EQ(ended->case_id, "0123456789abcdef");
  EXPECT_TRUE(launcher.idle());
  const std::string text = log("$(touch pwned); 'x'");
  EXPECT_NE(text.find("[--bind-to]\n[none]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("[-n]\n[1]\n[/opt/softwall dns]\n[" + what.run_directory.string() +
                      "]\n[--attempt]\n[3]\n[--wall-seconds]\n[90.7]\n"),
            std::string::npos)
      << text;
}

TEST_F(ProcessLauncherTest, ALogIsAppendedTo) {
  auto launcher = launcher_with("echo one attempt");
  for (int i = 0; i < 2; ++i) {
    (void)launcher.start(request());
    ASSERT_TRUE(wait_for_end(launcher));
  }
  EXPECT_EQ(log(), "one attempt\none attempt\n");
}

TEST_F(ProcessLauncherTest, ALogDoesNotGrowWithoutBound) {
  const auto file = RunFiles{request().run_directory}.log();
  std::ofstream(file) << "old";
  std::filesystem::resize_file(file, (16U << 20U) + 1U);
  auto launcher = launcher_with("echo new");
  (void)launcher.start(request());
  ASSERT_TRUE(wait_for_end(launcher));
  EXPECT_EQ(log(), "new\n");
  EXPECT_EQ(read_text(file.string() + ".old").substr(0, 3), "old");
}

TEST_F(ProcessLauncherTest, ALogDoesNotGrowWithoutBoundWhileItIsWritten) {
  auto launcher =
      launcher_with("head -c 17000000 /dev/zero; until [ -e go ]; do sleep 0.02; done; echo and on");
  const auto what = request();
  const auto file = RunFiles{what.run_directory}.log();
  (void)launcher.start(what);
  ASSERT_TRUE(wait_until(
      [&] { return std::filesystem::exists(file) && std::filesystem::file_size(file) == 17000000U; }));
  const bool made_room = wait_until([&] {
    (void)launcher.collect();
    return std::filesystem::exists(file.string() + ".old") && std::filesystem::file_size(file) == 0;
  });
  EXPECT_TRUE(made_room);
  std::ofstream(what.run_directory / "go") << "on";
  ASSERT_TRUE(wait_for_end(launcher));
  EXPECT_EQ(log(), "and on\n") << "the attempt goes on at the new end";
  EXPECT_EQ(std::filesystem::file_size(file.string() + ".old"), 17000000U);
}

TEST_F(ProcessLauncherTest, TemporaryFilesAreGoneAfterwards) {
  auto launcher =
      launcher_with("touch $TMPDIR/a $OMPI_MCA_btl_vader_backing_directory/b; echo $TMPDIR; kill -9 $$");
  const Scratch scratch(request().run_directory);
  (void)launcher.start(request());
  const auto ended = wait_for_end(launcher);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit_code, 128 + SIGKILL);
  EXPECT_EQ(log(), scratch.session().string() + "\n");
  EXPECT_FALSE(std::filesystem::exists(scratch.session()));
  EXPECT_FALSE(std::filesystem::exists(scratch.shared_memory()));
}

TEST_F(ProcessLauncherTest, AMissingMpirunIsSaidAtOnce) {
  ProcessLauncher launcher({folder_.path() / "nowhere", "/bin/true"});
  EXPECT_THROW((void)launcher.start(request()), std::runtime_error);
  EXPECT_TRUE(launcher.idle());
}

TEST_F(ProcessLauncherTest, StopLevelsReachTheProcess) {
  auto launcher = launcher_with(
      "trap 'echo usr1' USR1; trap 'echo term; exit 85' TERM; echo ready; while :; do sleep 0.05; done");
  const auto what = request();
  (void)launcher.start(what);
  ASSERT_TRUE(wait_until([&] { return log().find("ready") != std::string::npos; }));
  launcher.stop(what.run_directory, "", StopLevel::kCheckpoint);
  ASSERT_TRUE(wait_until([&] { return log().find("usr1") != std::string::npos; }));
  EXPECT_TRUE(launcher.collect().empty());
  launcher.stop(what.run_directory, "", StopLevel::kTerminate);
  const auto ended = wait_for_end(launcher);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit_code, 85);
}

TEST_F(ProcessLauncherTest, AnotherLauncherSeesAndStopsTheAttemptToo) {
  auto launcher = launcher_with("trap 'exit 85' USR1; echo ready; while :; do sleep 0.05; done");
  const auto what = request();
  const Handle handle = launcher.start(what);
  ASSERT_TRUE(wait_until([&] { return log().find("ready") != std::string::npos; }));
  ProcessLauncher later;
  EXPECT_EQ(later.presence(what.run_directory, handle), Presence::kRunning);
  EXPECT_FALSE(later.adopt(what, handle));
  later.stop(what.run_directory, handle, StopLevel::kCheckpoint);
  const auto ended = wait_for_end(launcher);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit_code, 85);
  EXPECT_EQ(later.presence(what.run_directory, handle), Presence::kGone);
}

TEST_F(ProcessLauncherTest, NothingResistsBeingKilled) {
  auto launcher = launcher_with(
      "trap '' USR1 TERM; set -m 2>/dev/null; sleep 60 & echo ready; while :; do sleep 0.05; done");
  const auto what = request();
  (void)launcher.start(what);
  ASSERT_TRUE(wait_until([&] { return log().find("ready") != std::string::npos; }));
  launcher.stop(what.run_directory, "", StopLevel::kTerminate);
  launcher.stop(what.run_directory, "", StopLevel::kKill);
  ASSERT_TRUE(wait_for_end(launcher));
  EXPECT_TRUE(ProcessesAtWork::look().in(what.run_directory).empty());
}

TEST_F(ProcessLauncherTest, AnAttemptLastsUntilItsLastRankIsGone) {
  // mpirun is gone at once; a "rank" in a process group of its own still writes for a while
  auto launcher = launcher_with("set -m 2>/dev/null; sh -c 'sleep 1; echo last words' & exit 1");
  const double start = monotonic_seconds();
  (void)launcher.start(request());
  ASSERT_TRUE(wait_for_end(launcher));
  EXPECT_GE(monotonic_seconds() - start, 1.0);
  EXPECT_EQ(log(), "last words\n");
}

TEST_F(ProcessLauncherTest, RanksThatStayBehindAreKilled) {
  auto launcher = launcher_with("set -m 2>/dev/null; sleep 60 & exit 1");
  const auto what = request();
  (void)launcher.start(what);
  ASSERT_TRUE(wait_for_end(launcher));
  EXPECT_TRUE(ProcessesAtWork::look().in(what.run_directory).empty());
}

TEST_F(ProcessLauncherTest, AnAttemptBehindALinkIsFoundAndHeardOf) {
  auto launcher = launcher_with("trap 'exit 85' USR1; echo ready; while :; do sleep 0.05; done");
  auto what = request("real");
  std::filesystem::create_symlink(what.run_directory, folder_.path() / "link");
  what.run_directory = folder_.path() / "link";
  (void)launcher.start(what);
  ASSERT_TRUE(wait_until([&] { return log("real").find("ready") != std::string::npos; }));
  EXPECT_EQ(launcher.presence(folder_.path() / "real", ""), Presence::kRunning);
  launcher.stop(what.run_directory, "", StopLevel::kCheckpoint);
  const auto ended = wait_for_end(launcher);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit_code, 85);
}

TEST_F(ProcessLauncherTest, AnAttemptWorksInItsRunDirectory) {
  auto launcher = launcher_with("pwd");
  (void)launcher.start(request());
  ASSERT_TRUE(wait_for_end(launcher));
  EXPECT_EQ(log(), std::filesystem::canonical(request().run_directory).string() + "\n");
}

TEST_F(ProcessLauncherTest, ALauncherThatCannotStartRanksIsRefusedInItsOwnWords) {
  folder_.write_script("mpirun", "echo -----; echo; echo 'There are not enough slots' >&2; exit 9");
  const std::string path = std::getenv("PATH");
  setenv("PATH", (folder_.path().string() + ":" + path).c_str(), 1);
  ProcessLauncher launcher;
  try {
    launcher.prepare("/bin/true", 2);
    ADD_FAILURE() << "accepted";
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find("exit status 9: There are not enough slots"), std::string::npos)
        << error.what();
  }
  EXPECT_NO_THROW(launcher.prepare("/bin/true", 0)) << "nothing is to be started";
  setenv("PATH", path.c_str(), 1);
}

TEST_F(ProcessLauncherTest, TheSolverIsToldWhenTheRunnerIsKilled) {
  const auto mpirun = folder_.write_script(
      "mpirun", "trap 'echo told; exit 85' USR1; echo ready; while :; do sleep 0.05; done");
  const auto what = request();
  test::ChildProcess runner([&] {
    ProcessLauncher launcher({mpirun, "/bin/true"});
    (void)launcher.start(what);
    while (true) pause();
    return 0;
  });
  ASSERT_TRUE(wait_until([&] { return log().find("ready") != std::string::npos; }));
  runner.send(SIGKILL);
  EXPECT_TRUE(wait_until([&] { return log().find("told") != std::string::npos; }));
  EXPECT_TRUE(wait_until([&] { return ProcessesAtWork::look().in(what.run_directory).empty(); }));
}

}  // namespace
}  // namespace softwall::campaign
