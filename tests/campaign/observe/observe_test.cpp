#include "campaign/observe/observe.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include "campaign/launch/process_launcher.hpp"
#include "campaign/observe/ladder.hpp"
#include "campaign/observe/run_reports.hpp"
#include "tests/campaign/core/examples.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/without_permission.hpp"

namespace softwall::campaign {
namespace {

class ObserveTest : public ::testing::Test {
 protected:
  ObserveTest() { std::filesystem::create_directories(run_.directory); }
  [[nodiscard]] Observation look() const { return observe(case_, run_, ProcessLauncher()); }

  softwall::test::TemporaryFolder folder_;
  Campaign campaign_ = tests::campaign_of(tests::elastic_campaign());
  CampaignCase case_ = campaign_.cases.front();  // the precursor, to t = 100
  const std::string id_ = case_.definition.id;
  RunFiles run_ = run_files(folder_.path(), case_);
};

TEST_F(ObserveTest, AnEmptyDirectoryIsANewCase) {
  EXPECT_EQ(look().state, CaseState::kNew);
  std::filesystem::remove_all(run_.directory);
  EXPECT_EQ(look().state, CaseState::kNew);
}

TEST_F(ObserveTest, CheckpointsWithoutASummaryMeanInterrupted) {
  test::write_checkpoint(run_, id_, 10, 1.0);
  test::write_checkpoint(run_, id_, 20, 2.0);
  const Observation seen = look();
  EXPECT_EQ(seen.state, CaseState::kInterrupted);
  EXPECT_EQ(seen.step, 20);
  EXPECT_EQ(seen.time, 2.0);
  EXPECT_EQ(seen.newest_checkpoint, run_.checkpoint(20));
}

TEST_F(ObserveTest, FinishedNeedsTheRecordOfThisCaseAndTheEndTime) {
  test::write_summary(run_, id_, 1, "finished", 1000, 100.0);
  EXPECT_EQ(look().state, CaseState::kFinished);
  test::write_summary(run_, id_, 1, "finished", 1000, 99.0);
  EXPECT_EQ(look().state, CaseState::kInterrupted) << "the end time was not reached";
  test::write_summary(run_, "another case", 1, "finished", 1000, 100.0);
  EXPECT_EQ(look().state, CaseState::kNew) << "the record of another case proves nothing";
}

TEST_F(ObserveTest, HalfASummaryProvesNothing) {
  test::write_summary(run_, id_, 1, "finished", 1000, 100.0);
  std::filesystem::resize_file(run_.summary(), std::filesystem::file_size(run_.summary()) / 2);
  EXPECT_EQ(look().state, CaseState::kNew);
  for (const char* text : {"", "[]", "null", R"({"format":2})", R"({"format":1,"case_id":7})"}) {
    folder_.write(run_.summary(), text);
    EXPECT_EQ(look().state, CaseState::kNew) << text;
  }
}

TEST_F(ObserveTest, ARecordOlderThanTheLastAttemptIsNotItsEnd) {
  test::write_checkpoint(run_, id_, 10, 1.0);
  test::write_summary(run_, id_, 1, "failed", 10, 1.0);
  EXPECT_EQ(look().state, CaseState::kFailed);
  write_run_record(run_, {id_, 2, "a handle", "here", "2026-01-01T00:00:00Z"});
  EXPECT_EQ(read_run_record(run_)->handle, "a handle");
  EXPECT_EQ(read_run_record(run_)->host, "here");
  EXPECT_EQ(look().state, CaseState::kInterrupted);
  EXPECT_EQ(look().attempts, 2);
}

TEST_F(ObserveTest, ARunRecordOfTheFirstVersionIsStillRead) {
  folder_.write(
      run_.directory / "run.json",
      R"({"format": 1, "case_id": "0123456789abcdef", "attempt": 3, "started": "2026-01-01T00:00:00Z",
                    "process": {"host": "node 7", "boot_id": "b", "pid": 42, "start_ticks": 9}})");
  const auto record = read_run_record(run_);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->attempt, 3);
  EXPECT_EQ(record->host, "node 7");
  EXPECT_EQ(nlohmann::json::parse(record->handle).at("pid"), 42);
}

TEST_F(ObserveTest, DivergedStaysDiverged) {
  test::write_summary(run_, id_, 1, "diverged", 10, 1.0);
  EXPECT_EQ(look().state, CaseState::kDiverged);
}

TEST_F(ObserveTest, AHeldSolverLockMeansRunning) {
  test::write_checkpoint(run_, id_, 10, 1.0);
  folder_.write(run_.lock(), "");
  const int lock = open(run_.lock().c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(flock(lock, LOCK_EX), 0);
  EXPECT_TRUE(look().running);
  EXPECT_EQ(look().state, CaseState::kRunning);
  EXPECT_EQ(look().reason, "") << "what runs has not ended";
  close(lock);
  EXPECT_FALSE(look().running);
  EXPECT_EQ(look().reason, "ended without a word");
}

/// Whether it still works nobody else may ask; that it has ended it says itself.
TEST_F(ObserveTest, OfAnotherUsersSolverOnlyItsReportIsBelieved) {
  std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
  test::write_checkpoint(run_, id_, 10, 1.0);
  write_run_record(run_, {.case_id = id_, .attempt = 1, .handle = "", .host = "there", .started = ""});
  folder_.write(run_.lock(), "");
  {
    const test::WithoutPermission somebody_else(run_.lock());
    EXPECT_EQ(look().presence, Presence::kUnknown);
    EXPECT_EQ(look().state, CaseState::kRunning);
  }
  test::write_summary(run_, id_, 1, "interrupted", 10, 1.0);
  const test::WithoutPermission somebody_else(run_.lock());
  EXPECT_EQ(look().state, CaseState::kInterrupted);
}

TEST_F(ObserveTest, ACaseKeepsItsDirectoryWhenItsLabelChanges) {
  const std::string old = case_.directory;
  campaign_.cases.front().directory = "cases/renamed-" + id_.substr(0, 8);
  keep_existing_directories(campaign_, folder_.path(), existing_directories(folder_.path()));
  EXPECT_EQ(campaign_.cases.front().directory, old);
}

TEST_F(ObserveTest, BadCheckpointsAreSetAsideAndGoodOnesNotTouched) {
  test::write_checkpoint(run_, id_, 10, 1.0);
  const auto damaged = test::write_checkpoint(run_, id_, 20, 2.0);
  const auto foreign = test::write_checkpoint(run_, "another case", 30, 3.0);
  std::filesystem::resize_file(damaged, std::filesystem::file_size(damaged) - 1);
  const auto before = std::filesystem::last_write_time(run_.checkpoint(10));

  const Ladder ladder = check_ladder(run_, id_);
  EXPECT_EQ(ladder.newest, run_.checkpoint(10));
  EXPECT_EQ(ladder.header.step, 10);
  ASSERT_EQ(ladder.set_aside.size(), 2U);
  EXPECT_FALSE(std::filesystem::exists(damaged));
  EXPECT_FALSE(std::filesystem::exists(foreign));
  EXPECT_TRUE(std::filesystem::exists(damaged.string() + ".bad"));
  EXPECT_EQ(std::filesystem::last_write_time(run_.checkpoint(10)), before);
  EXPECT_TRUE(check_ladder(run_, id_).set_aside.empty());
}

/// A job in a queue has made no step, whatever the attempt before it had reported last.
TEST_F(ObserveTest, AReportOfAnEarlierAttemptIsNoneOfTheWork) {
  const auto report = [&](int attempt) {
    Status status;
    status.case_id = id_;
    status.attempt = attempt;
    folder_.write(run_.status(), nlohmann::json(status).dump());
  };
  Observation seen;
  seen.case_id = id_;
  seen.attempts = 2;
  report(2);
  EXPECT_FALSE(report_of_work(run_, seen)) << "nobody works there";
  seen.running = true;
  for (const Presence presence : {Presence::kQueued, Presence::kRunning}) {
    seen.presence = presence;
    report(1);
    EXPECT_FALSE(report_of_work(run_, seen));
    report(2);
    EXPECT_TRUE(report_of_work(run_, seen));
  }
  report(0);
  EXPECT_TRUE(report_of_work(run_, seen)) << "a solver that was started by hand";
}

/// Whoever has gone back to an older program for a moment keeps what the newer one has computed.
TEST_F(ObserveTest, ACheckpointOfAnotherVersionIsLeftAlone) {
  test::write_checkpoint(run_, id_, 10, 1.0);
  const auto newest = test::write_checkpoint(run_, id_, 20, 2.0);
  CheckpointHeader header = read_checkpoint_header(newest);
  header.format = 2;
  write_header(newest, header);
  const Ladder ladder = check_ladder(run_, id_);
  EXPECT_FALSE(ladder.newest);
  EXPECT_TRUE(ladder.set_aside.empty());
  EXPECT_NE(ladder.unreadable.find("format 2"), std::string::npos) << ladder.unreadable;
  EXPECT_TRUE(std::filesystem::exists(newest));
  EXPECT_EQ(look().needs_person, ladder.unreadable);
}

}  // namespace
}  // namespace softwall::campaign
