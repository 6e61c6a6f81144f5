#include "campaign/store/import_directories.hpp"

#include <gtest/gtest.h>

#include "campaign/observe/run_reports.hpp"
#include "solver/run_directory/statistics_file.hpp"
#include "tests/analysis/samples.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"
#include "tests/campaign/runner/fake_launcher.hpp"
#include "tests/campaign/store/recorded_campaign.hpp"

/// What a store that was made anew learns from the run directories of a campaign.
namespace softwall::campaign::tests {
namespace {

/// One that knows a single attempt, which waits in its queue.
class QueueOfOne final : public test::LauncherWithoutMemory {
 public:
  Handle start(const LaunchRequest&) override { return ""; }
  std::vector<EndedAttempt> collect() override { return {}; }
  void stop(const std::filesystem::path&, const Handle&, StopLevel) override {}
  [[nodiscard]] bool idle() const override { return true; }
  [[nodiscard]] std::vector<Presence> presences(const std::vector<AttemptPlace>& places) const override {
    std::vector<Presence> found;
    for (const AttemptPlace& place : places)
      found.push_back(place.handle == "job 7" ? Presence::kQueued : Presence::kGone);
    return found;
  }
};

class ImportDirectoriesTest : public RecordedCampaign {
 protected:
  ImportedDirectories import_all() {
    return import_directories(store, campaign.cases, folder.path(), QueueOfOne());
  }
  void finish(const CampaignCase& which) {
    test::write_summary(run_files(folder.path(), which), which.definition.id, 1, "finished", 1000,
                        which.definition.run.end_time);
  }
  [[nodiscard]] std::string attempts_of_one() {
    return answer(store, "SELECT group_concat(attempt || coalesce(outcome, '-'), ' ') FROM attempts");
  }
};

TEST_F(ImportDirectoriesTest, AnAttemptThatHasNotEndedStaysOpen) {
  test::write_checkpoint(run, one.definition.id, 10, 1.0);
  test::write_summary(run, one.definition.id, 1, "interrupted", 10, 1.0);
  write_run_record(run, {one.definition.id, 2, "job 7", "here", "2026-01-01T00:00:00Z"});
  import_all();
  EXPECT_EQ(attempts_of_one(), "2-");
  EXPECT_EQ(store.find_case(one.definition.id)->state, CaseState::kRunning);
  EXPECT_TRUE(store.find_case(one.definition.id)->had_checkpoints);
}

TEST_F(ImportDirectoriesTest, AnAttemptThatIsGoneHasEnded) {
  test::write_checkpoint(run, one.definition.id, 10, 1.0);
  write_run_record(run, {one.definition.id, 2, "job 8", "here", "2026-01-01T00:00:00Z"});
  import_all();
  EXPECT_EQ(attempts_of_one(), "2lost");
  EXPECT_EQ(store.find_case(one.definition.id)->state, CaseState::kInterrupted);
}

TEST_F(ImportDirectoriesTest, ResultsComeWithThemAndWhatHasNoneIsTold) {
  const CampaignCase& other = campaign.cases[1];
  finish(one);
  finish(other);
  auto statistics = analysis::samples::elastic_statistics({}, 20);
  statistics.case_id = one.definition.id;
  analysis::write_statistics(run.statistics(), statistics);
  const ImportedDirectories imported = import_all();
  EXPECT_EQ(imported.results, 1);
  ASSERT_EQ(imported.troubles.size(), 1U);
  EXPECT_TRUE(imported.troubles[0].starts_with(other.definition.label + ": no result: "))
      << imported.troubles[0];
  EXPECT_TRUE(store.result_origin(one.definition.id).has_value());
}

}  // namespace
}  // namespace softwall::campaign::tests
