#include <gtest/gtest.h>

#include <csignal>

#include <filesystem>

#include "tests/campaign/runner/fake_launcher.hpp"
#include "tests/campaign/runner/runner_fixture.hpp"

/// What becomes of a case of which something is damaged, missing or cannot be read.
namespace softwall::campaign {
namespace {

using test::FakeLauncher;

TEST_F(RunnerTest, DamagedStatisticsAreMadeAgainFromTheLastCheckpoint) {
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  run(launcher);
  std::filesystem::resize_file(run_files(folder_.path(), campaign_.cases[2]).statistics(), 700);
  std::filesystem::remove(run_files(folder_.path(), campaign_.cases[3]).statistics());
  FakeLauncher second([&](const LaunchRequest& request) { return finish(request); });
  const RunnerReport report = run(second);
  EXPECT_EQ(report.finished, 5U);
  EXPECT_TRUE(report.failed.empty());
  ASSERT_EQ(second.started.size(), 2U);
  EXPECT_EQ(second.started[0].case_id, id(2));
  EXPECT_EQ(second.started[1].case_id, id(3));
}

/// A case of which every attempt ends in order after step 500.
class LadderTest : public RunnerTest {
 protected:
  LadderTest() {
    FakeLauncher launcher([&](const LaunchRequest& request) {
      if (case_of(request.case_id).is_precursor) return finish(request);
      test::write_checkpoint(RunFiles{request.run_directory}, request.case_id, 500, 1.0);
      return 1;
    });
    run(launcher);
  }
  [[nodiscard]] RunFiles files() const { return run_files(folder_.path(), campaign_.cases[1]); }
};

TEST_F(LadderTest, ACheckpointThatCannotBeReadIsWaitedForAndLeftAlone) {
  const auto newest = files().checkpoint(600);
  std::filesystem::create_symlink(newest, newest);  // whoever opens it is refused by the system
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  const RunnerReport report = run(launcher);
  ASSERT_EQ(report.unfinished.size(), 1U);
  EXPECT_NE(report.unfinished[0].reason.find("checkpoint-000000600.h5: it cannot be read"), std::string::npos)
      << report.unfinished[0].reason;
  EXPECT_TRUE(report.failed.empty());
  EXPECT_TRUE(std::filesystem::is_symlink(newest));
  EXPECT_EQ(launcher.started.size(), 3U) << "the others go on";
}

TEST_F(LadderTest, ACaseThatHadCheckpointsDoesNotStartOverUnasked) {
  std::filesystem::resize_file(files().checkpoint(500), 4096);
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  for (int i = 0; i < 2; ++i) {
    const RunnerReport report = run(launcher);
    ASSERT_EQ(report.unfinished.size(), 1U);
    EXPECT_NE(report.unfinished[0].reason.find("--start-over"), std::string::npos);
  }
  EXPECT_EQ(launcher.started.size(), 3U);
  RunnerOptions options;
  options.start_over = true;
  EXPECT_EQ(run(launcher, options).finished, 5U);
}

/// A disk that is not mounted, or a scratch that was purged.
TEST_F(LadderTest, ACaseWhoseRunDirectoryIsGoneDoesNotStartOverUnasked) {
  std::filesystem::remove_all(files().directory);
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  for (int i = 0; i < 2; ++i) {
    const RunnerReport report = run(launcher);
    ASSERT_EQ(report.unfinished.size(), 1U);
    EXPECT_NE(report.unfinished[0].reason.find("--start-over"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(files().directory));
  }
  EXPECT_EQ(launcher.started.size(), 3U) << "the others go on";
  RunnerOptions options;
  options.start_over = true;
  EXPECT_EQ(run(launcher, options).finished, 5U);
}

std::vector<std::string> started_by(const FakeLauncher& launcher) {
  std::vector<std::string> ids;
  for (const LaunchRequest& request : launcher.started) ids.push_back(request.case_id);
  return ids;
}

/// What has finished, and what it has left, is nothing that a person asks to be computed again.
TEST_F(LadderTest, OnlyWhatHasNotFinishedStartsOver) {
  FakeLauncher first(
      [&](const LaunchRequest& request) { return request.case_id == id(1) ? 1 : finish(request); });
  run(first);
  std::filesystem::remove_all(run_files(folder_.path(), campaign_.cases[0]).checkpoints());
  std::filesystem::remove_all(run_files(folder_.path(), campaign_.cases[2]).directory);
  RunnerOptions options;
  options.start_over = true;
  FakeLauncher second([&](const LaunchRequest& request) { return finish(request); });
  EXPECT_EQ(run(second, options).finished, 5U);
  EXPECT_EQ(started_by(second), std::vector{id(1)}) << "from its own checkpoint; the precursor is not needed";
  std::filesystem::remove_all(files().directory);
  Store::open(folder_.path(), OpenMode::kReadWrite).set_state(id(1), CaseState::kInterrupted, "");
  FakeLauncher third([&](const LaunchRequest& request) { return finish(request); });
  EXPECT_EQ(run(third, options).finished, 5U);
  EXPECT_EQ(started_by(third), (std::vector{id(0), id(1)})) << "which starts from the precursor";
}

TEST_F(RunnerTest, APrecursorWithoutCheckpointsGetsAnotherWindow) {
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  run(launcher);
  std::filesystem::remove_all(run_files(folder_.path(), campaign_.cases[0]).checkpoints());
  campaign_.cases[0].window_start = 110;
  run(launcher);
  EXPECT_EQ(store().result_origin(id(0)).value().window_asked, 110);
  EXPECT_EQ(launcher.started.size(), 5U);
}

TEST_F(RunnerTest, AFinishedCaseWhoseRunDirectoryIsGoneKeepsItsResultAndIsNotComputedAgain) {
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  run(launcher);
  std::filesystem::remove_all(folder_.path() / "cases");
  FakeLauncher second([&](const LaunchRequest& request) { return finish(request); });
  const RunnerReport report = run(second);
  EXPECT_EQ(report.finished, 5U);
  EXPECT_TRUE(second.started.empty());
  Store known = store();
  EXPECT_EQ(tests::answer(known, "SELECT count(*) FROM results WHERE state = 'finished' AND re_tau > 0"),
            "5");
}

/// A file where the folder should be stands for every folder that cannot be read.
TEST_F(RunnerTest, CasesWaitForAStartThatCannotBeReadAtPresent) {
  FakeLauncher first([&](const LaunchRequest& request) {
    return case_of(request.case_id).is_precursor ? finish(request) : 1;
  });
  run(first);
  const RunFiles precursor = run_files(folder_.path(), campaign_.cases[0]);
  std::filesystem::remove_all(precursor.checkpoints());
  std::ofstream(precursor.checkpoints()) << "no folder";
  FakeLauncher second([&](const LaunchRequest& request) { return finish(request); });
  const RunnerReport report = run(second);
  EXPECT_EQ(report.finished, 1U);
  EXPECT_TRUE(report.failed.empty());
  ASSERT_EQ(report.unfinished.size(), 4U);
  EXPECT_NE(report.unfinished[0].reason.find("checkpoints cannot be read"), std::string::npos)
      << report.unfinished[0].reason;
  EXPECT_TRUE(second.started.empty());
}

/// Its checkpoint is read in full where somebody has yet to start from it, and nowhere else.
TEST_F(RunnerTest, AStartThatNobodyNeedsAnyMoreIsNotLookedAt) {
  FakeLauncher first([&](const LaunchRequest& request) {
    if (case_of(request.case_id).is_precursor) return finish(request);
    test::write_checkpoint(RunFiles{request.run_directory}, request.case_id, 500, 1.0);
    return 1;
  });
  run(first);
  const RunFiles precursor = run_files(folder_.path(), campaign_.cases[0]);
  std::filesystem::resize_file(precursor.checkpoint(1000), 4096);
  FakeLauncher second([&](const LaunchRequest& request) { return finish(request); });
  EXPECT_EQ(run(second).finished, 5U);
  EXPECT_EQ(second.started.size(), 4U);
  EXPECT_TRUE(std::filesystem::exists(precursor.checkpoint(1000)));
}

/// It was killed after it had written history.json and before the store had the same.
TEST_F(RunnerTest, RecordsTheEndThatAKilledRunnerHadSeen) {
  campaign_.cases.resize(1);
  test::FakeLauncher launcher([&](const LaunchRequest& request) {
    if (request.attempt > 1) return finish(request);
    test::write_checkpoint(RunFiles{request.run_directory}, request.case_id, 10, 1.0);
    return 128 + SIGSEGV;
  });
  run(launcher);
  const std::string question =
      "SELECT outcome || reason || exit_code || ended FROM attempts WHERE attempt = 1";
  Store before = store();
  const std::string seen = tests::answer(before, question);
  EXPECT_NE(seen.find("SIGSEGV"), std::string::npos) << seen;
  Store::open(folder_.path(), OpenMode::kReadWrite)
      .connection()
      .execute(
          "UPDATE attempts SET ended = NULL, outcome = NULL, reason = NULL, exit_code = NULL WHERE attempt = "
          "1;"
          "UPDATE cases SET state = 'running'");
  run(launcher);
  Store after = store();
  EXPECT_EQ(tests::answer(after, question), seen);
}

}  // namespace
}  // namespace softwall::campaign
