#include "campaign/runner/runner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <thread>
#include <utility>

#include "campaign/observe/observe.hpp"
#include "solver/run_directory/exit_codes.hpp"
#include "solver/run_directory/statistics_file.hpp"
#include "tests/analysis/samples.hpp"
#include "tests/campaign/core/examples.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"
#include "tests/campaign/runner/fake_launcher.hpp"
#include "tests/campaign/runner/runner_fixture.hpp"
#include "tests/campaign/store/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {
namespace {

using test::FakeLauncher;

TEST_F(RunnerTest, RunsThePrecursorFirstThenAsManyAsFit) {
  std::vector<std::string> order;
  FakeLauncher launcher([&](const LaunchRequest& request) {
    order.push_back(request.case_id);
    return finish(request);
  });
  const RunnerReport report = run(launcher);
  EXPECT_EQ(report.finished, 5U);
  EXPECT_TRUE(report.failed.empty());
  EXPECT_TRUE(report.unfinished.empty());
  EXPECT_EQ(launcher.started.size(), 5U);
  EXPECT_EQ(order.front(), id(0));
  EXPECT_EQ(launcher.started.front().ranks, 2);
  // every elastic case was given the precursor's last checkpoint, by a path that works from its directory
  for (std::size_t i = 1; i < 5; ++i) {
    const RunFiles files = run_files(folder_.path(), campaign_.cases[i]);
    const Case written = read_case(files.case_file());
    EXPECT_TRUE(std::filesystem::exists(files.directory / written.run.initial_checkpoint));
    EXPECT_TRUE(written.run.initial_checkpoint.is_relative());
    EXPECT_TRUE(store().result_origin(id(i)).has_value());
  }
}

TEST_F(RunnerTest, NeverUsesMoreCoresThanAllowed) {
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  run(launcher);
  EXPECT_EQ(launcher.most_ranks, 2);
}

/// A database browser that holds results.db for longer than SQLite waits by itself must not end a campaign.
TEST_F(RunnerTest, WaitsForAStoreThatAnotherProgramHolds) {
  { static_cast<void>(Store::open(folder_.path(), OpenMode::kCreate)); }
  Connection browser = Connection::open(store_path(folder_.path()), Access::kReadWrite);
  std::thread holder;
  FakeLauncher launcher([&](const LaunchRequest& request) {
    if (request.case_id == id(0)) {
      browser.execute("BEGIN IMMEDIATE");
      holder = std::thread([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(11500));
        browser.execute("COMMIT");
      });
    }
    return finish(request);
  });
  const RunnerReport report = run(launcher);
  holder.join();
  EXPECT_EQ(report.finished, 5U);
  EXPECT_EQ(store().past_attempts(id(0)).size(), 1U);
}

TEST_F(RunnerTest, PausesWhenTheStoreCannotBeWritten) {
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  Signals signals;
  Progress progress("");
  Store full = Store::open(folder_.path(), OpenMode::kCreate);
  full.record_campaign(campaign_);
  // As on a full disk: no page may be added.
  full.connection().execute("PRAGMA max_page_count = " +
                            std::to_string(full.connection().integer("PRAGMA page_count")));
  RunnerOptions options;
  options.poll = std::chrono::milliseconds(1);
  campaign_.spec_text = std::string(100000, ' ');
  EXPECT_EQ(
      Runner(campaign_, folder_.path(), {launcher, full, progress, signals}, options).run().unfinished.size(),
      5U)
      << "before anything is started, too";
  EXPECT_TRUE(launcher.started.empty());
  campaign_.spec_text.clear();
  Runner runner(campaign_, folder_.path(), {launcher, full, progress, signals}, options);
  const RunnerReport report = runner.run();
  EXPECT_LT(report.finished, 5U);
  ASSERT_FALSE(report.unfinished.empty());
  EXPECT_TRUE(report.failed.empty());
  EXPECT_NE(report.unfinished.back().reason.find("cannot be written"), std::string::npos);
  EXPECT_EQ(run(launcher).finished, 5U) << "and goes on when there is room";
}

TEST_F(RunnerTest, ANewStoreKnowsTheAttemptsOfTheOldOne) {
  bool first = true;
  FakeLauncher launcher([&](const LaunchRequest& request) {
    if (request.case_id == id(2) && std::exchange(first, false)) return 139;
    return finish(request);
  });
  run(launcher);
  ASSERT_EQ(store().past_attempts(id(2)).size(), 2U);
  for (const char* suffix : {"", "-wal", "-shm"})
    std::filesystem::remove(store_path(folder_.path()).string() + suffix);
  run(launcher);
  const auto past = store().past_attempts(id(2));
  ASSERT_EQ(past.size(), 2U);
  EXPECT_EQ(past[0].end.exit_code, 139);
  EXPECT_EQ(past[1].end.outcome, AttemptOutcome::kFinished);
}

TEST_F(RunnerTest, RunningAgainKeepsWhatIsFinished) {
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  run(launcher);
  FakeLauncher again([](const LaunchRequest&) { return kDone; });
  EXPECT_EQ(run(again).finished, 5U);
  EXPECT_TRUE(again.started.empty());
}

TEST_F(RunnerTest, ExitStatusZeroWithoutARecordIsAFailureAndRetriesAreBounded) {
  FakeLauncher launcher(
      [&](const LaunchRequest& request) { return request.case_id == id(2) ? kDone : finish(request); });
  const RunnerReport report = run(launcher);
  EXPECT_EQ(report.finished, 4U) << "the others go on";
  ASSERT_EQ(report.failed.size(), 1U);
  EXPECT_EQ(report.failed[0].label, campaign_.cases[2].definition.label);
  EXPECT_EQ(store().attempts(id(2)), 2);
  EXPECT_EQ(store().find_case(id(2))->state, CaseState::kFailed);
}

TEST_F(RunnerTest, WhoeverRunsTheCampaignAgainAsksForAnotherTry) {
  FakeLauncher broken([](const LaunchRequest&) { return 139; });
  EXPECT_EQ(run(broken).failed.size(), 5U);
  FakeLauncher repaired([&](const LaunchRequest& request) { return finish(request); });
  EXPECT_EQ(run(repaired).finished, 5U);
}

TEST_F(RunnerTest, AttemptsThatGetFurtherAreNotCountedAsFailures) {
  std::map<std::string, int> tries;
  FakeLauncher launcher([&](const LaunchRequest& request) {
    const int number = ++tries[request.case_id];
    if (number == 6) return finish(request);
    test::write_checkpoint(RunFiles{request.run_directory}, request.case_id, number * 10, number);
    return 139;  // crashed, but with a new checkpoint each time
  });
  EXPECT_EQ(run(launcher).finished, 5U);
  EXPECT_EQ(store().attempts(id(1)), 6);
}

TEST_F(RunnerTest, ADivergedCaseIsNeverRunAgain) {
  FakeLauncher launcher([&](const LaunchRequest& request) {
    return request.case_id == id(1) ? diverge(request) : finish(request);
  });
  EXPECT_EQ(run(launcher).failed.size(), 1U);
  FakeLauncher again([&](const LaunchRequest& request) { return finish(request); });
  EXPECT_EQ(run(again).failed.size(), 1U);
  EXPECT_TRUE(again.started.empty());
  EXPECT_EQ(store().attempts(id(1)), 1);
}

/// Another version may do better: once somebody has removed what it left, it may be tried again, and once
/// only.
TEST_F(RunnerTest, ADivergedCaseMayStartOverWhenItsCheckpointsAreRemoved) {
  FakeLauncher diverging([&](const LaunchRequest& request) {
    return request.case_id == id(1) ? diverge(request) : finish(request);
  });
  run(diverging);
  std::filesystem::remove_all(run_files(folder_.path(), campaign_.cases[1]).directory);
  FakeLauncher unasked([&](const LaunchRequest& request) { return finish(request); });
  EXPECT_EQ(run(unasked).failed.size(), 1U);
  EXPECT_TRUE(unasked.started.empty());
  RunnerOptions options;
  options.start_over = true;
  FakeLauncher still_diverging([](const LaunchRequest& request) { return diverge(request); });
  EXPECT_EQ(run(still_diverging, options).failed.size(), 1U);
  EXPECT_EQ(still_diverging.started.size(), 1U);
  FakeLauncher mended([&](const LaunchRequest& request) { return finish(request); });
  EXPECT_EQ(run(mended, options).finished, 5U);
}

TEST_F(RunnerTest, AnElasticCaseWaitsForeverForAPrecursorThatFails) {
  FakeLauncher launcher([](const LaunchRequest&) { return 1; });
  const RunnerReport report = run(launcher);
  EXPECT_EQ(report.failed.size(), 5U);
  EXPECT_EQ(launcher.started.size(), 2U);
}

TEST_F(RunnerTest, AFullDiskPausesTheCaseButDoesNotCondemnIt) {
  FakeLauncher launcher([&](const LaunchRequest& request) {
    return request.case_id == id(3) ? static_cast<int>(ExitCode::kIoFailure) : finish(request);
  });
  const RunnerReport report = run(launcher);
  EXPECT_EQ(report.finished, 4U);
  ASSERT_EQ(report.unfinished.size(), 1U);
  EXPECT_NE(report.unfinished[0].reason.find("disk full"), std::string::npos);
  EXPECT_EQ(store().attempts(id(3)), 1);
}

/// However few cores there are, so that the others wait for those of the case in trouble.
TEST_F(RunnerTest, ACaseThatCannotBeStartedHoldsNobodyUp) {
  campaign_.execution.cores = 2;
  FakeLauncher precursor_only([&](const LaunchRequest& request) {
    return request.case_id == id(0) ? finish(request) : static_cast<int>(ExitCode::kIoFailure);
  });
  run(precursor_only);
  for (std::size_t i : {1U, 2U}) {
    const auto file = RunFiles{folder_.path() / campaign_.cases[i].directory}.case_file();
    std::filesystem::remove(file);
    std::filesystem::create_directory(file);
  }
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  const RunnerReport report = run(launcher);
  EXPECT_EQ(report.finished, 3U);
  ASSERT_EQ(report.unfinished.size(), 2U);
  EXPECT_NE(report.unfinished[0].reason.find("case.json"), std::string::npos) << report.unfinished[0].reason;
}

/// A file where the folder should be stands for every folder that cannot be read.
TEST_F(RunnerTest, AFolderOfCheckpointsThatCannotBeReadHoldsNobodyUp) {
  const RunFiles broken{folder_.path() / campaign_.cases[1].directory};
  std::filesystem::create_directories(broken.directory);
  std::ofstream(broken.checkpoints()) << "no folder";
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  const RunnerReport report = run(launcher);
  EXPECT_EQ(report.finished, 4U);
  ASSERT_EQ(report.unfinished.size(), 1U);
  EXPECT_NE(report.unfinished[0].reason.find("checkpoints cannot be read"), std::string::npos)
      << report.unfinished[0].reason;
}

TEST_F(RunnerTest, AStopRequestStartsNothingMoreAndLeavesTheRestForResume) {
  FakeLauncher launcher([&](const LaunchRequest& request) {
    raise(SIGTERM);  // taken by the runner's next look at its signals
    test::write_checkpoint(RunFiles{request.run_directory}, request.case_id, 10, 1.0);
    test::write_summary(RunFiles{request.run_directory}, request.case_id, request.attempt, "interrupted", 10,
                        1.0);
    return static_cast<int>(ExitCode::kInterrupted);
  });
  const RunnerReport stopped = run(launcher);
  EXPECT_LE(launcher.started.size(), 2U);  // the signal is seen after the next launch at the latest
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.unfinished.size(), 5U);
  EXPECT_TRUE(stopped.failed.empty());
  FakeLauncher rest([&](const LaunchRequest& request) { return finish(request); });
  EXPECT_EQ(run(rest).finished, 5U);
}

/// What a request may have done is one thing, what the solver did by itself meanwhile another.
TEST_F(RunnerTest, AfterAStopOnlyWhatMayHaveBeenEndedByItCountsAsStopped) {
  campaign_.cases.resize(1);
  const auto stopped_with = [&](int exit_code) {
    bool is_asked = false;
    test::WatchedLauncher launcher([&](const LaunchRequest&) -> std::optional<int> {
      if (std::exchange(is_asked, true)) return exit_code;
      raise(SIGTERM);
      return std::nullopt;
    });
    EXPECT_TRUE(run(launcher).stopped);
    Store after = store();
    return tests::answer(after, "SELECT outcome FROM attempts ORDER BY attempt DESC LIMIT 1");
  };
  EXPECT_EQ(stopped_with(128 + SIGTERM), "interrupted");
  EXPECT_EQ(stopped_with(128 + SIGKILL), "interrupted");
  EXPECT_EQ(stopped_with(1), "interrupted") << "an mpirun that was terminated";
  EXPECT_EQ(stopped_with(128 + SIGSEGV), "failed");
  EXPECT_EQ(stopped_with(static_cast<int>(ExitCode::kBadCase)), "bad case");
}

TEST_F(RunnerTest, AJobThatHadToMakeRoomBeforeItsFirstStepIsNoFailureOfItsCase) {
  class Preempting final : public test::LauncherWithoutMemory {
   public:
    Handle start(const LaunchRequest& request) override {
      running = request;
      return "it";
    }
    std::vector<EndedAttempt> collect() override {
      if (!running) return {};
      const LaunchRequest ended = *std::exchange(running, std::nullopt);
      if (ended.attempt > 3) return {{ended.case_id, finish(ended)}};
      test::write_summary(RunFiles{ended.run_directory}, ended.case_id, ended.attempt, "interrupted", 0, 0.0);
      return {{ended.case_id, std::nullopt, Verdict{AttemptOutcome::kNodeFailure, "had to make room"}}};
    }
    void stop(const std::filesystem::path&, const Handle&, StopLevel) override {}
    [[nodiscard]] bool idle() const override { return !running; }
    std::optional<LaunchRequest> running;
    std::function<int(const LaunchRequest&)> finish;
  } launcher;
  launcher.finish = [&](const LaunchRequest& request) { return finish(request); };
  campaign_.cases.resize(1);
  EXPECT_EQ(run(launcher).finished, 1U);
  Store after = store();
  EXPECT_EQ(tests::answer(after, "SELECT group_concat(outcome) FROM attempts"),
            "node failure,node failure,node failure,finished");
}

TEST_F(RunnerTest, AnInterruptedAttemptThatMadeNoStepIsNotRetriedForEver) {
  FakeLauncher launcher([&](const LaunchRequest& request) {
    test::write_summary(RunFiles{request.run_directory}, request.case_id, request.attempt, "interrupted", 0,
                        0.0);
    return static_cast<int>(ExitCode::kInterrupted);
  });
  EXPECT_EQ(run(launcher).failed.size(), 5U);
}

TEST_F(RunnerTest, ADamagedLastCheckpointOfThePrecursorIsComputedAgain) {
  FakeLauncher first([&](const LaunchRequest& request) {
    if (!case_of(request.case_id).is_precursor) return 1;
    test::write_checkpoint(RunFiles{request.run_directory}, request.case_id, 500, 50.0);
    return finish(request);
  });
  run(first);
  const RunFiles precursor = run_files(folder_.path(), campaign_.cases[0]);
  std::filesystem::resize_file(precursor.checkpoint(1000), 4096);
  FakeLauncher second([&](const LaunchRequest& request) { return finish(request); });
  EXPECT_EQ(run(second).finished, 5U);
  EXPECT_EQ(second.started.front().case_id, id(0));
  EXPECT_TRUE(std::filesystem::exists(precursor.checkpoint(1000).string() + ".bad"));
  EXPECT_TRUE(std::filesystem::exists(precursor.checkpoint(500)));
}

TEST_F(RunnerTest, ALostStoreIsMadeAgainFromTheRunDirectories) {
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  run(launcher);
  for (const char* suffix : {"", "-wal", "-shm"}) {
    std::filesystem::remove(store_path(folder_.path()).string() + suffix);
  }
  FakeLauncher none([](const LaunchRequest&) { return 1; });
  EXPECT_EQ(run(none).finished, 5U);
  EXPECT_TRUE(none.started.empty());
  EXPECT_EQ(store().attempts(id(1)), 1);
  EXPECT_TRUE(store().result_origin(id(1)).has_value());
}

TEST_F(RunnerTest, ALongerAverageReplacesTheResultAndTheSameOneDoesNot) {
  FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  run(launcher);
  const std::string first = store().result_origin(id(2))->recorded;
  const RunFiles files = run_files(folder_.path(), campaign_.cases[1]);
  auto longer = analysis::samples::elastic_statistics({}, 30);
  longer.case_id = id(1);
  analysis::write_statistics(files.statistics(), longer);
  FakeLauncher none([](const LaunchRequest&) { return 1; });
  run(none);
  EXPECT_EQ(store().result_origin(id(1))->window_end, longer.end.back());
  run(none);
  EXPECT_EQ(store().result_origin(id(2))->recorded, first) << "what has not changed is not written again";
}

TEST_F(RunnerTest, FinishedWithoutStatisticsIsTold) {
  FakeLauncher launcher([&](const LaunchRequest& request) {
    const int code = finish(request);
    if (request.case_id == id(4)) std::filesystem::remove(RunFiles{request.run_directory}.statistics());
    return code;
  });
  const RunnerReport report = run(launcher);
  EXPECT_EQ(report.finished, 4U);
  ASSERT_EQ(report.failed.size(), 1U);
  EXPECT_NE(report.failed[0].reason.find("without a result"), std::string::npos);
}

}  // namespace
}  // namespace softwall::campaign
