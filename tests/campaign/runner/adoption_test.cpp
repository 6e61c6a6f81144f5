#include <gtest/gtest.h>

#include <algorithm>

#include "campaign/observe/run_reports.hpp"
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

  /// What an earlier softwall had done when it was killed: the precursor's first attempt is with the system.
  Handle leave_precursor_behind() {
    const CampaignCase& precursor = campaign_.cases.front();
    const RunFiles run = run_files(folder_.path(), precursor);
    std::filesystem::create_directories(run.directory);
    Store store = Store::open(folder_.path(), OpenMode::kCreate);
    store.record_campaign(campaign_);
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

TEST_F(AdoptionTest, WithoutALimitOfItsOwnASchedulerGetsEverything) {
  const test::BatchLauncher launcher(system_);
  EXPECT_EQ(cores_to_use(3, launcher), 3);
  EXPECT_GT(cores_to_use(0, launcher), 1'000'000);
}

}  // namespace
}  // namespace softwall::campaign
