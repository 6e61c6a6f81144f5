#include "campaign/store/import_results.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "campaign/observe/history.hpp"
#include "campaign/observe/observe.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"
#include "tests/campaign/store/recorded_campaign.hpp"

/// What a store learns from run directories that say more, or less, than it knows.
namespace softwall::campaign::tests {
namespace {

class ImportTest : public RecordedCampaign {
 protected:
  /// A result over the window that starts here, recorded while the case was running.
  void record_window(double start) {
    analysis::DerivedQuantities derived = result_made_of(100);
    derived.window_asked = start;
    store.record_result(one.definition.id, derived, "");
  }
  [[nodiscard]] bool has_result() const { return store.result_origin(one.definition.id).has_value(); }
};

/// A backup of results.db that is two attempts old took the place of a damaged one.
TEST_F(ImportTest, AttemptsThatABackupDoesNotKnowComeBack) {
  std::vector<PastAttempt> told;
  for (int attempt = 1; attempt <= 4; ++attempt)
    told.push_back({attempt, {"here", 1, ""}, failed_at(10 * attempt)});
  test::write_summary(run, one.definition.id, 4, "interrupted", 40, 4.0);
  write_history(run, one.definition.id, told);
  for (int known = 0; known < 2; ++known)
    store.restore_attempt(one.definition.id, told[known].attempt, told[known].start, told[known].end);

  for (int again = 0; again < 2; ++again) import_history(store, one, run, observe_files(one, run));
  EXPECT_EQ(answer(store, "SELECT group_concat(attempt || ':' || step) FROM attempts"),
            "1:10,2:20,3:30,4:40");
}

TEST_F(ImportTest, AveragesOverAnotherWindowGoWhereThisOneHasNoneYet) {
  one.window_start = 30;
  record_window(30);
  EXPECT_FALSE(import_result_so_far(store, one, run, CaseState::kInterrupted));
  EXPECT_TRUE(has_result()) << "statistics that cannot be read now take nothing away";
  one.window_start = 100;
  EXPECT_FALSE(import_result_so_far(store, one, run, CaseState::kInterrupted));
  EXPECT_FALSE(has_result());
}

TEST_F(ImportTest, AFlowThatDivergedHasNoAverages) {
  one.window_start = 30;
  record_window(30);
  EXPECT_FALSE(import_result_so_far(store, one, run, CaseState::kDiverged));
  EXPECT_FALSE(has_result());
}

/// It was recorded on the way, by a clock that was years ahead.
TEST_F(ImportTest, AResultThatEndsLongBeforeItsCaseIsNotItsLast) {
  record_window(one.window_start);  // up to t = 50
  store.connection().execute("UPDATE quantities SET recorded = '2099-01-01T00:00:00.000Z'");
  test::write_summary(run, one.definition.id, 1, "finished", 1000, 100.0);
  std::ofstream(run.statistics()) << "its time of change is all that counts";
  const auto origin = store.result_origin(one.definition.id).value();
  const double block = one.definition.physics.statistics.block_length;
  EXPECT_TRUE(is_recorded(origin, one, run, 50.0 + 0.9 * block));
  EXPECT_FALSE(is_recorded(origin, one, run, 50.0 + 1.1 * block));
}

}  // namespace
}  // namespace softwall::campaign::tests
