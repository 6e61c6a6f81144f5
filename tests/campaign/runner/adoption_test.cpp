#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "campaign/observe/history.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/store/store_file.hpp"
#include "campaign/system/clock.hpp"
#include "tests/campaign/runner/fake_batch_system.hpp"
#include "tests/campaign/runner/runner_fixture.hpp"

/// Attempts that an earlier softwall left with a batch system, which does not end them with it.
namespace softwall::campaign {
namespace {

class AdoptionTest : public RunnerTest {
 protected:
  AdoptionTest() {
    campaign_ = tests::campaign_of(tests::elastic_campaign());
    system_.play = [this](const LaunchRequest& request) { finish(request); };
  }

  /// What an earlier softwall had done when it was killed: an attempt at the precursor is with the system,
  /// after so many that were interrupted.
  Handle leave_precursor_behind(int attempts_before = 0) {
    const CampaignCase& precursor = campaign_.cases.front();
    const RunFiles run = run_files(folder_.path(), precursor);
    std::filesystem::create_directories(run.directory);
    Store store = Store::open(folder_.path(), OpenMode::kCreate);
    store.record_campaign(campaign_);
    for (int i = 0; i < attempts_before; ++i) {
      AttemptEnd end;
      end.outcome = AttemptOutcome::kInterrupted;
      store.end_attempt(precursor_id(), store.begin_attempt(precursor_id(), {"login node", 1, ""}), end);
    }
    write_history(run, precursor_id(), store.past_attempts(precursor_id()));
    const int attempt = store.begin_attempt(precursor.definition.id, {"login node", 1, ""});
    const Handle handle = system_.submit({precursor.definition.id, run.directory, attempt, 1, std::nullopt});
    write_run_record(run, {precursor.definition.id, attempt, handle, "login node", "2026-01-01T00:00:00Z"});
    store.attempt_started(precursor.definition.id, attempt, handle);
    return handle;
  }

  [[nodiscard]] const std::string& precursor_id() const { return campaign_.cases.front().definition.id; }

  test::BatchSystem system_;
};

TEST_F(AdoptionTest, AJobOfAnEarlierSoftwallIsWaitedForAndNotSubmittedAgain) {
  leave_precursor_behind();
  test::BatchLauncher launcher(system_);
  const RunnerReport report = run(launcher);
  EXPECT_EQ(report.finished, 5U);
  EXPECT_EQ(launcher.adopted, std::vector{precursor_id()});
  EXPECT_EQ(launcher.started.size(), 4U);
  EXPECT_EQ(std::ranges::count(launcher.started, precursor_id()), 0);
  EXPECT_TRUE(launcher.stops.empty());
  Store store = Store::open(folder_.path(), OpenMode::kReadOnly);
  EXPECT_EQ(tests::answer(store,
                          "SELECT group_concat(attempt || ' ' || outcome || ' ' || handle) FROM attempts"
                          " WHERE case_id = '" +
                              precursor_id() + "'"),
            "1 finished job 1");
}

/// results.db was lost, or set aside because it was damaged.
TEST_F(AdoptionTest, AJobIsAdoptedIntoAStoreThatKnowsNothing) {
  leave_precursor_behind(2);
  for (const auto& file : std::filesystem::directory_iterator(folder_.path())) {
    if (file.path().filename().string().starts_with("results.db")) std::filesystem::remove(file.path());
  }
  test::BatchLauncher launcher(system_);
  EXPECT_EQ(run(launcher).finished, 5U);
  EXPECT_EQ(launcher.adopted, std::vector{precursor_id()});
  EXPECT_TRUE(launcher.stops.empty());
  Store store = Store::open(folder_.path(), OpenMode::kReadOnly);
  EXPECT_EQ(
      tests::answer(store, "SELECT group_concat(attempt || ' ' || outcome) FROM attempts WHERE case_id = '" +
                               precursor_id() + "'"),
      "1 interrupted,2 interrupted,3 finished");
}

TEST_F(AdoptionTest, AQueuedJobCountsAsRunning) {
  leave_precursor_behind();
  const test::BatchLauncher launcher(system_);
  EXPECT_EQ(
      observe(campaign_.cases.front(), run_files(folder_.path(), campaign_.cases.front()), launcher).state,
      CaseState::kRunning);
}

TEST_F(AdoptionTest, AJobThatHasEndedMeanwhileIsNotAdopted) {
  leave_precursor_behind();
  system_.pass_time();
  system_.pass_time();
  test::BatchLauncher launcher(system_);
  EXPECT_EQ(run(launcher).finished, 5U);
  EXPECT_TRUE(launcher.adopted.empty());
  EXPECT_EQ(launcher.started.size(), 4U);
}

TEST_F(AdoptionTest, SilenceIsNotTakenForAnEnd) {
  leave_precursor_behind();
  system_.answers = false;
  const test::BatchLauncher silent(system_);
  EXPECT_TRUE(
      observe(campaign_.cases.front(), run_files(folder_.path(), campaign_.cases.front()), silent).running);
  test::BatchLauncher launcher(system_);
  EXPECT_EQ(run(launcher).finished, 5U);
  EXPECT_EQ(std::ranges::count(launcher.started, precursor_id()), 0);
}

TEST_F(AdoptionTest, AnAdoptedJobIsStoppedByItsHandle) {
  const Handle handle = leave_precursor_behind();
  system_.play = [](const LaunchRequest&) {};
  test::BatchLauncher launcher(system_);
  RunnerOptions options;
  options.stall_seconds = -1;  // at once
  EXPECT_EQ(run(launcher, options).failed.size(), 5U);
  ASSERT_FALSE(launcher.stops.empty());
  EXPECT_EQ(launcher.stops.front().first, handle);
}

TEST_F(AdoptionTest, JobsGoOnWhenTheRunnerIsAskedToLeave) {
  test::BatchLauncher launcher(system_);
  launcher.on_pass = [&] {
    if (launcher.started.empty()) return;
    system_.is_full = true;
    raise(SIGINT);
  };
  const RunnerReport report = run(launcher);
  EXPECT_TRUE(report.stopped);
  EXPECT_EQ(report.unfinished.size(), 5U);
  EXPECT_TRUE(launcher.stops.empty()) << "nobody was asked to end";
  EXPECT_EQ(launcher.started.size(), 1U);
  system_.is_full = false;
  test::BatchLauncher next(system_);
  EXPECT_EQ(run(next).finished, 5U);
  EXPECT_EQ(next.adopted, std::vector{precursor_id()});
}

/// A database browser holds results.db when jobs end: what cannot be recorded now is found by the next
/// softwall.
TEST_F(AdoptionTest, JobsGoOnWhenTheRunnerIsAskedToLeaveALockedStore) {
  { static_cast<void>(Store::open(folder_.path(), OpenMode::kCreate)); }
  Connection browser = Connection::open(store_path(folder_.path()), Access::kReadWrite);
  test::BatchLauncher launcher(system_);
  bool is_held = false;
  launcher.on_pass = [&] {
    if (launcher.started.size() < 5 || std::exchange(is_held, true)) return;
    browser.execute("BEGIN IMMEDIATE");
    raise(SIGINT);
    raise(SIGTERM);
  };
  EXPECT_TRUE(run(launcher).stopped);
  EXPECT_TRUE(launcher.stops.empty()) << "nobody was asked to end";
  browser.execute("ROLLBACK");
  test::BatchLauncher next(system_);
  EXPECT_EQ(run(next).finished, 5U);
  EXPECT_TRUE(next.started.empty());
}

/// A limit of jobs, or cases that wait for company in a job: nobody submits them once softwall has left.
TEST_F(AdoptionTest, WhatWasNotYetSubmittedIsNotLeftAsIfItRan) {
  test::BatchLauncher launcher(system_);
  system_.most_jobs = 2;  // the precursor's and one more
  launcher.on_pass = [&] {
    if (launcher.started.size() < 5) return;
    system_.is_full = true;
    raise(SIGINT);
  };
  EXPECT_EQ(run(launcher).unfinished.size(), 4U);
  Store left = store();
  EXPECT_EQ(tests::answer(left,
                          "SELECT group_concat(n) FROM (SELECT count(*) || ' ' || state AS n FROM cases"
                          " GROUP BY state ORDER BY state)"),
            "1 finished,3 new,1 running");
  system_.is_full = false;
  system_.most_jobs = 1000;
  test::BatchLauncher next(system_);
  EXPECT_EQ(run(next).finished, 5U);
  EXPECT_EQ(next.adopted.size(), 1U);
  Store after = store();
  EXPECT_EQ(tests::answer(after, "SELECT count(*) FROM attempts WHERE outcome = 'not started'"), "3");
  EXPECT_EQ(tests::answer(after, "SELECT count(*) FROM attempts WHERE outcome = 'lost'"), "0");
}

TEST_F(AdoptionTest, NothingMoreIsSubmittedOnceTheUserHasAskedToStop) {
  test::BatchLauncher launcher(system_);
  launcher.on_start = [&] {
    if (launcher.started.size() == 2) raise(SIGINT);
  };
  EXPECT_TRUE(run(launcher).stopped);
  EXPECT_EQ(launcher.started.size(), 2U) << "the precursor and the first of four that may start together";
}

TEST_F(AdoptionTest, JobsAreNotLookedAtAsOftenAsProcesses) {
  test::BatchLauncher launcher(system_);
  std::vector<double> looks;  // at the precursor's job, while it waits
  launcher.on_pass = [&] {
    if (launcher.started.size() == 1) looks.push_back(monotonic_seconds());
    system_.is_full = looks.size() < 20;
  };
  RunnerOptions options;
  options.poll = std::chrono::milliseconds(1);
  options.patient_poll = std::chrono::milliseconds(20);
  Signals signals;
  Progress progress("");
  Store results = Store::open(folder_.path(), OpenMode::kCreate);
  EXPECT_EQ(Runner(campaign_, folder_.path(), {launcher, results, progress, signals}, options).run().finished,
            5U);
  EXPECT_GT(looks.back() - looks.front(), 19 * 0.019);
}

TEST_F(AdoptionTest, AJobThatWaitsForLongIsNotTakenForOneThatHangs) {
  test::BatchLauncher launcher(system_);
  int passes = 0;
  launcher.on_pass = [&] { system_.is_full = ++passes % 20 != 0; };
  system_.play = [this](const LaunchRequest& request) { finish(request); };
  RunnerOptions options;
  options.stall_seconds = options.begin_seconds = 0.005;
  system_.is_full = true;
  EXPECT_EQ(run(launcher, options).finished, 5U);
}

/// The time that its ranks may take to begin is counted from when it leaves the queue.
TEST_F(AdoptionTest, AJobThatHasJustLeftTheQueueIsGivenItsTime) {
  constexpr double kWait = 1.5, kBegin = 1.0;  // with the limit, 2, between the longer one and their sum
  campaign_.cases.resize(1);
  test::BatchLauncher launcher(system_);
  double since = monotonic_seconds();
  launcher.on_pass = [&] {
    const bool queued = system_.jobs.empty() || system_.jobs.begin()->second.state == Presence::kQueued;
    const double now = monotonic_seconds();
    system_.is_full = now - since < (queued ? kWait : kBegin);
    if (!system_.is_full) since = now;
  };
  RunnerOptions options;
  options.begin_seconds = 2.0;
  EXPECT_EQ(run(launcher, options).finished, 1U);
  EXPECT_TRUE(launcher.stops.empty());
}

/// A runner that is killed while its request is on the way to the batch system must find the job again.
TEST_F(AdoptionTest, TheIntendedHandleIsOnDiskBeforeAnythingIsStarted) {
  class Launcher final : public test::LauncherWithoutMemory {
   public:
    [[nodiscard]] Handle intended(const LaunchRequest& request) const override {
      return "job of attempt " + std::to_string(request.attempt);
    }
    Handle start(const LaunchRequest& request) override {
      const auto record = read_run_record(RunFiles{request.run_directory});
      if (record && record->attempt == request.attempt) found = record->handle;
      throw std::runtime_error("killed here");
    }
    std::vector<EndedAttempt> collect() override { return {}; }
    void stop(const std::filesystem::path&, const Handle&, StopLevel) override {}
    [[nodiscard]] bool idle() const override { return true; }
    Handle found;
  };
  Launcher launcher;
  static_cast<void>(run(launcher));
  EXPECT_EQ(launcher.found, "job of attempt 1");
}

TEST_F(AdoptionTest, WithoutALimitOfItsOwnASchedulerGetsEverything) {
  const test::BatchLauncher launcher(system_);
  EXPECT_EQ(cores_to_use(3, launcher), 3);
  EXPECT_GT(cores_to_use(0, launcher), 1'000'000);
}

}  // namespace
}  // namespace softwall::campaign
