#include "campaign/launch/slurm_queue.hpp"

#include <gtest/gtest.h>

#include "tests/campaign/launch/fake_slurm.hpp"

namespace softwall::campaign {
namespace {

TEST(SlurmQueue, ReadsWhatSqueueWrites) {
  const auto jobs = parse_squeue(
      "12|PENDING|0|Resources|softwall.a|\n13|FAILED|768|NonZeroExitCode|x|y z|\n"
      "14_[1-9]|COMPLETED|9||b|\n");
  ASSERT_TRUE(jobs);
  ASSERT_EQ(jobs->size(), 3U);
  EXPECT_EQ((*jobs)[0].name, "softwall.a");
  EXPECT_EQ((*jobs)[0].why, "Resources");
  EXPECT_FALSE((*jobs)[0].exit_code) << "it has not ended";
  EXPECT_EQ((*jobs)[1].name, "x|y z");
  EXPECT_EQ((*jobs)[1].exit_code, 3);
  EXPECT_EQ((*jobs)[2].exit_code, 137);
  EXPECT_TRUE(parse_squeue("")->empty());
}

TEST(SlurmQueue, HalfAnAnswerIsNone) {
  for (const char* text : {"12|PENDING|0|Resources|softwall.a|\n13|RUN", "12|PENDING|0|Resources|softwall.a|",
                           "slurm_load_jobs error\n", "\n", "{\"jobs\": []}\n", "x|PENDING|0|None|a|\n",
                           "12|pending|0|None|a|\n", "12|PENDING|zero|None|a|\n", "12|PENDING|0|None|a\n",
                           "12||0|None|a|\n", "JOBID STATE\n12|PENDING|0|None|a|\n"})
    EXPECT_FALSE(parse_squeue(text)) << text;
}

TEST(SlurmQueue, ReadsWhatSacctWrites) {
  const auto jobs = parse_sacct("12|CANCELLED by 1000|0:15|softwall.a\n13|FAILED|3:0|b\n");
  ASSERT_TRUE(jobs);
  EXPECT_EQ((*jobs)[0].state, "CANCELLED");
  EXPECT_EQ((*jobs)[0].exit_code, 143);
  EXPECT_EQ((*jobs)[1].exit_code, 3);
  EXPECT_FALSE(parse_sacct("Slurm accounting storage is disabled\n"));
}

TEST(SlurmQueue, AWordOfANewerSlurmIsUnknownAndNoEnd) {
  EXPECT_EQ(presence_in("PENDING"), Presence::kQueued);
  EXPECT_EQ(presence_in("COMPLETING"), Presence::kRunning);
  EXPECT_EQ(presence_in("TIMEOUT"), Presence::kGone);
  EXPECT_EQ(presence_in("HIBERNATING"), Presence::kUnknown);
  EXPECT_TRUE(leaves_no_process("CANCELLED"));
  EXPECT_FALSE(leaves_no_process("NODE_FAIL"));
}

TEST(SlurmQueue, AsksLessOftenWhileNothingHappensOrNobodyAnswers) {
  const test::FakeSlurm slurm;
  SlurmQueue queue({.shortest = 100, .longest = 200, .longest_silence = 400});
  queue.refresh();
  queue.refresh();
  EXPECT_TRUE(queue.answers());
  EXPECT_EQ(slurm.calls("squeue").size(), 1U);
}

TEST(SlurmQueue, SilenceIsToldInTheWordsOfSlurm) {
  const test::FakeSlurm slurm;
  SlurmQueue queue(test::kQuickPace);
  slurm.play("squeue", "echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1");
  queue.refresh();
  EXPECT_FALSE(queue.answers());
  EXPECT_EQ(queue.trouble(), "slurm_load_jobs error: Unable to contact slurm controller");
  slurm.play("squeue", "sleep 60");
  queue.refresh();
  EXPECT_FALSE(queue.answers());
  EXPECT_EQ(queue.trouble(), "squeue does not answer");
  slurm.play("squeue", "cat queue");
  queue.refresh();
  EXPECT_TRUE(queue.answers());
}

}  // namespace
}  // namespace softwall::campaign
