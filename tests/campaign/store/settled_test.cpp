#include "campaign/store/settled.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "campaign/observe/observe.hpp"
#include "campaign/store/import_results.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"
#include "tests/campaign/runner/fake_launcher.hpp"
#include "tests/campaign/store/recorded_campaign.hpp"

namespace softwall::campaign::tests {
namespace {

/// Times of change and of records are compared to the millisecond.
void let_time_pass() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }

class SettledTest : public RecordedCampaign {
 protected:
  SettledTest() { finish(one); }
  /// Leaves the case as a runner would have left it at its end.
  void finish(const CampaignCase& which) {
    const RunFiles files = run_files(folder.path(), which);
    const double end_time = which.definition.run.end_time;
    test::write_summary(files, which.definition.id, 1, "finished", 500, end_time);
    AttemptEnd end;
    end.outcome = AttemptOutcome::kFinished;
    end.step = 500;
    end.time = end_time;
    store.end_attempt(which.definition.id, store.begin_attempt(which.definition.id, {"here", 1, ""}), end);
    let_time_pass();
    store.set_state(which.definition.id, CaseState::kFinished, "end time reached");
  }
  [[nodiscard]] bool settled(const CampaignCase& which) const {
    return is_settled(which, store.find_case(which.definition.id).value(), run_files(folder.path(), which));
  }
};

TEST_F(SettledTest, IsWhatFinishedAndWasLeftAlone) {
  EXPECT_TRUE(settled(one));
  EXPECT_FALSE(settled(campaign.cases[1])) << "has not run";
  finish(campaign.cases.front());
  EXPECT_FALSE(settled(campaign.cases.front())) << "a precursor";
  one.definition.run.end_time *= 2;
  EXPECT_FALSE(settled(one)) << "its end time was raised";
}

TEST_F(SettledTest, EndsWithWhateverAppearsOrGoes) {
  let_time_pass();
  std::ofstream(run.status()) << "a solver that was started by hand reports";
  EXPECT_FALSE(settled(one));
  let_time_pass();
  store.set_state(one.definition.id, CaseState::kRunning, "");
  store.set_state(one.definition.id, CaseState::kFinished, "");
  EXPECT_TRUE(settled(one));
  let_time_pass();
  std::filesystem::remove(run.summary());
  EXPECT_FALSE(settled(one));
  std::filesystem::remove_all(run.directory);
  EXPECT_FALSE(settled(one));
}

TEST_F(SettledTest, EndsWhenAFileIsDamagedInItsPlace) {
  let_time_pass();
  std::ofstream(run.summary()) << "{";
  EXPECT_FALSE(settled(one));
}

/// Somebody makes room: the store has to learn which checkpoints are left.
TEST_F(SettledTest, EndsWhenACheckpointIsRemoved) {
  const auto checkpoint = test::write_checkpoint(run, one.definition.id, 100, 1.0);
  let_time_pass();
  store.set_state(one.definition.id, CaseState::kRunning, "");
  store.set_state(one.definition.id, CaseState::kFinished, "");
  ASSERT_TRUE(settled(one));
  let_time_pass();
  std::filesystem::remove(checkpoint);
  EXPECT_FALSE(settled(one));
}

/// All that a copy of the campaign's folder holds has changed later than the store knows.
TEST_F(SettledTest, BeginsAnewWhenTheStoreIsBroughtUpToACopy) {
  let_time_pass();
  test::write_checkpoint(run, one.definition.id, 500, one.definition.run.end_time);
  ASSERT_FALSE(settled(one));
  let_time_pass();
  import_checkpoints(store, one.definition.id, run);
  EXPECT_TRUE(settled(one));
}

/// What it says is what its files would say, and none of them is opened.
TEST_F(SettledTest, IsObservedWithoutItsFiles) {
  const test::LauncherWithoutMemory& launcher = test::FakeLauncher([](const LaunchRequest&) { return 0; });
  const Observation opened = observe_files(one, run);
  std::ofstream(run.summary()) << "damaged before the store was brought up to it";
  let_time_pass();
  store.set_state(one.definition.id, CaseState::kRunning, "");
  store.set_state(one.definition.id, CaseState::kFinished, "end time reached");
  const auto seen = observe_with_records(campaign, folder.path(), launcher, store.all_cases()).back();
  EXPECT_EQ(seen.state, CaseState::kFinished);
  EXPECT_EQ(seen.case_id, opened.case_id);
  EXPECT_EQ(seen.step, opened.step);
  EXPECT_EQ(seen.time, opened.time);
  EXPECT_EQ(seen.end_time, opened.end_time);
  EXPECT_EQ(seen.attempts, opened.attempts);
}

}  // namespace
}  // namespace softwall::campaign::tests
