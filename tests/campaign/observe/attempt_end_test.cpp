#include "campaign/observe/attempt_end.hpp"

#include <gtest/gtest.h>

#include <string>

#include "campaign/observe/observe.hpp"
#include "tests/campaign/core/examples.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign {
namespace {

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

}  // namespace
}  // namespace softwall::campaign
