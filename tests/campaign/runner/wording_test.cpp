#include "campaign/runner/wording.hpp"

#include <gtest/gtest.h>

#include "campaign/core/words.hpp"

namespace softwall::campaign {
namespace {

CampaignCase soft_wall() {
  CampaignCase one;
  one.definition.id = "0123456789abcdef";
  one.definition.label = "G=0.5";
  one.definition.run.end_time = 250;
  return one;
}

Observation at(std::int64_t step, double time) {
  Observation seen;
  seen.step = step;
  seen.time = time;
  return seen;
}

TEST(Wording, OfAStartSaysFromWhereToWhereAndOnHowManyRanks) {
  Ladder ladder;
  EXPECT_EQ(describe_start(soft_wall(), 1, ladder), "G=0.5: started to t = 250, 1 rank");
  EXPECT_EQ(describe_start(soft_wall(), 1, ladder, true), "G=0.5: submitted to t = 250, 1 rank");
  ladder.newest = "checkpoint-000000040.h5";
  ladder.header.step = 40;
  ladder.header.time = 12.3;
  EXPECT_EQ(describe_start(soft_wall(), 2, ladder),
            "G=0.5: resumed from t = 12.3 (step 40) to t = 250, 2 ranks");
}

TEST(Wording, OfAnEndSaysWhatIsSafe) {
  AttemptEnd end;
  end.outcome = AttemptOutcome::kFinished;
  EXPECT_EQ(describe_end_of_attempt(soft_wall(), end, at(900, 250)), "G=0.5: finished at t = 250 (step 900)");
  end.outcome = AttemptOutcome::kInterrupted;
  EXPECT_EQ(describe_end_of_attempt(soft_wall(), end, at(9, 2.5)),
            "G=0.5: interrupted; safe at t = 2.5 (step 9)");
  end.reason = "stopped on request";
  EXPECT_EQ(describe_end_of_attempt(soft_wall(), end, at(9, 2.5)),
            "G=0.5: stopped on request; safe at t = 2.5 (step 9)");
  end.outcome = AttemptOutcome::kDiverged;
  end.reason = "velocity of 200 at step 10";
  EXPECT_EQ(describe_end_of_attempt(soft_wall(), end, at(9, 2.5)),
            "G=0.5: diverged: velocity of 200 at step 10");
  end.outcome = AttemptOutcome::kFailed;
  end.reason = "exit status 1";
  EXPECT_EQ(describe_end_of_attempt(soft_wall(), end, at(9, 2.5)),
            "G=0.5: attempt failed: exit status 1; safe at t = 2.5 (step 9)");
}

TEST(Wording, OfAStopSaysWhatAnotherOneWouldDo) {
  EXPECT_EQ(describe_stop(1, 1),
            "stopping: waiting for 1 case to write a checkpoint (Ctrl-C again: do not wait)");
  EXPECT_EQ(describe_stop(2, 3), "ending 3 cases within seconds (Ctrl-C again: at once)");
  EXPECT_EQ(describe_stop(3, 3), "ending 3 cases at once");
  EXPECT_EQ(describe_stop(1, 0), "stopping");
  EXPECT_EQ(describe_leaving(1, 0), "leaving; 1 job goes on without softwall, and the next run waits for it");
  EXPECT_EQ(describe_leaving(3, 1),
            "leaving; 3 jobs go on without softwall, and the next run waits for them; 1 case not submitted "
            "yet, which the next run does");
  EXPECT_EQ(describe_leaving(0, 2), "leaving; 2 cases not submitted yet, which the next run does");
}

TEST(Wording, OfProgressNamesWhatIsRunning) {
  Campaign campaign;
  campaign.cases = {soft_wall(), soft_wall(), soft_wall()};
  campaign.cases[1].definition.id = "b";
  campaign.cases[2].definition.id = "c";
  campaign.cases[2].definition.label = "G=1";
  std::vector<Observation> seen(3);
  seen[1].state = CaseState::kFinished;
  Status half, little;
  half.time = 125;
  little.time = 2.5;
  EXPECT_EQ(describe_progress(campaign, seen, {{"0123456789abcdef", half}, {"c", little}}, 200),
            "1/3 finished | G=0.5 t=125 50 %, G=1 t=2.5 1 % | about 3 min left");
}

TEST(Wording, OfNumbersIsShort) {
  EXPECT_EQ(short_number(0.1 + 0.2), "0.3");
  EXPECT_EQ(short_number(123456), "1.235e+05");
}

}  // namespace
}  // namespace softwall::campaign
