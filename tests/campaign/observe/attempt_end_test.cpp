#include "campaign/observe/attempt_end.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <string>

#include "campaign/observe/observe.hpp"
#include "solver/run_directory/exit_codes.hpp"
#include "solver/run_directory/status.hpp"
#include "tests/campaign/core/examples.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {
namespace {

AttemptOutcome meant_by(int exit_code) { return meaning_of(exit_code).outcome; }
AttemptOutcome meant_by(ExitCode code) { return meant_by(static_cast<int>(code)); }

TEST(ExitMeaning, TheSolversOwnStatusesSayWhatToDoNext) {
  EXPECT_EQ(meant_by(ExitCode::kDone), AttemptOutcome::kFailed) << "it proves nothing without a summary";
  EXPECT_EQ(meant_by(ExitCode::kFailed), AttemptOutcome::kFailed);
  EXPECT_EQ(meant_by(ExitCode::kIoFailure), AttemptOutcome::kIoFailure);
  EXPECT_EQ(meant_by(ExitCode::kDiverged), AttemptOutcome::kDiverged);
  EXPECT_EQ(meant_by(ExitCode::kCheckpointRefused), AttemptOutcome::kBadCheckpoint);
  EXPECT_EQ(meant_by(ExitCode::kBadCase), AttemptOutcome::kBadCase);
  EXPECT_EQ(meant_by(ExitCode::kInterrupted), AttemptOutcome::kInterrupted);
}

TEST(ExitMeaning, ASignalIsACrashOrSomebodyElsesDoing) {
  for (const int signal : {SIGKILL, SIGTERM, SIGUSR1})
    EXPECT_EQ(meant_by(128 + signal), AttemptOutcome::kKilled) << signal;
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL})
    EXPECT_EQ(meant_by(128 + signal), AttemptOutcome::kFailed) << signal;
  EXPECT_EQ(meant_by(128 + SIGXFSZ), AttemptOutcome::kIoFailure);
  EXPECT_NE(std::string(meaning_of(128 + SIGSEGV).text).find("SIGSEGV"), std::string::npos);
}

TEST(ExitMeaning, EveryStatusHasOne) {
  for (int status = 0; status < 256; ++status) {
    EXPECT_EQ(meaning_of(status).exit_code, status);
    EXPECT_STRNE(meaning_of(status).text, "");
  }
  EXPECT_EQ(meant_by(42), AttemptOutcome::kFailed);
  EXPECT_STREQ(meaning_of(42).text, "the solver failed");
}

TEST(AttemptEnd, IsToldByTheSummaryOfThatAttemptOrElseByTheExitStatus) {
  const test::TemporaryFolder folder;
  const CampaignCase one = tests::campaign_of(tests::elastic_campaign()).cases.front();
  const std::string& id = one.definition.id;
  const RunFiles run = run_files(folder.path(), one);
  test::write_checkpoint(run, id, 10, 1.0);
  test::write_summary(run, id, 3, "interrupted", 10, 1.0);
  EXPECT_EQ(describe_end(one, run, 3, {"", 85}).outcome, AttemptOutcome::kInterrupted);
  EXPECT_EQ(describe_end(one, run, 4, {"", 137}).outcome, AttemptOutcome::kKilled);
  EXPECT_EQ(describe_end(one, run, 4, {"", 75}).outcome, AttemptOutcome::kIoFailure);
  EXPECT_EQ(describe_end(one, run, 4, {"", 0}).outcome, AttemptOutcome::kFailed) << "exit 0 proves nothing";
  EXPECT_EQ(describe_end(one, run, 4, {"", 137}).reason,
            "killed from outside, or out of memory (SIGKILL) (exit status 137)");
  EXPECT_EQ(describe_end(one, run, 4).outcome, AttemptOutcome::kLost);
  const EndedAttempt timed_out{"", 143, Verdict{AttemptOutcome::kTimeout, "its job reached its time limit"}};
  EXPECT_EQ(describe_end(one, run, 4, timed_out).outcome, AttemptOutcome::kTimeout);
  EXPECT_EQ(describe_end(one, run, 3, timed_out).outcome, AttemptOutcome::kInterrupted)
      << "the solver's own word comes first";
  EXPECT_EQ(describe_end(one, run, 4, {"", 1}).step, 10);
}

TEST(AttemptEnd, WithoutASummaryItsTimeIsThatOfItsLastStatus) {
  const test::TemporaryFolder folder;
  const CampaignCase one = tests::campaign_of(tests::elastic_campaign()).cases.front();
  const RunFiles run = run_files(folder.path(), one);
  test::write_summary(run, one.definition.id, 3, "interrupted", 10, 1.0);
  Status status;
  status.case_id = one.definition.id;
  status.attempt = 4;
  status.wall_seconds = 90.5;
  std::ofstream(run.status()) << nlohmann::json(status);
  EXPECT_EQ(describe_end(one, run, 4, {"", 137}).wall_seconds, 90.5);
  EXPECT_EQ(describe_end(one, run, 3, {"", 137}).wall_seconds, 1.0);
  EXPECT_FALSE(describe_end(one, run, 5, {"", 137}).wall_seconds) << "the status is that of another attempt";
}

}  // namespace
}  // namespace softwall::campaign
