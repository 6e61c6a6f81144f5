#include "campaign/launch/sbatch_answer.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace softwall::campaign {
namespace {

Answer refusal(const std::string& words) { return {"", words, 1}; }

TEST(SbatchAnswer, TheNumberOfTheJobIsTakenFromAWholeLineAlone) {
  EXPECT_EQ(job_number_in({"12\n", "", 0}), "12");
  EXPECT_EQ(job_number_in({"12;cluster\n", "", 0}), "12");
  for (const char* half : {"", "12", "\n", ";cluster\n", "12 \n", "Submitted batch job 12\n"})
    EXPECT_EQ(job_number_in({half, "", 0}), std::nullopt) << half;
  EXPECT_EQ(job_number_in({"12\n", "", 1}), std::nullopt);
  EXPECT_EQ(job_number_in({"12\n", "", std::nullopt}), std::nullopt);
}

TEST(SbatchAnswer, TroubleOfThisHourMayPassAndAMistakeOfTheCampaignMayNot) {
  for (const char* passing :
       {"sbatch: error: Batch job submission failed: Unable to contact slurm controller (connect failure)",
        "sbatch: error: Batch job submission failed: Socket timed out on send/recv operation",
        "sbatch: error: Batch job submission failed: Requested node configuration is not available",
        "allocation failure: Required node not available (down, drained or reserved)"})
    EXPECT_TRUE(may_pass(refusal(passing))) << passing;
  for (const char* lasting : {"sbatch: error: invalid partition specified: nowhere",
                              "sbatch: error: Batch job submission failed: Invalid account or "
                              "account/partition combination specified"})
    EXPECT_FALSE(may_pass(refusal(lasting))) << lasting;
  EXPECT_TRUE(may_pass({"", "", std::nullopt})) << "nobody answered";
}

TEST(SbatchAnswer, OnlyARefusalInWordsOfItsOwnLeavesNoDoubt) {
  EXPECT_FALSE(is_doubtful(refusal("sbatch: error: invalid partition specified: nowhere")));
  EXPECT_TRUE(is_doubtful(refusal("")));
  EXPECT_TRUE(is_doubtful(refusal("sbatch: error: Socket timed out on send/recv operation")));
  EXPECT_TRUE(is_doubtful(refusal("sbatch: error: Zero Bytes were transmitted or received")));
  EXPECT_TRUE(is_doubtful({"", "killed", 137})) << "it was cut off by a signal";
  EXPECT_TRUE(is_doubtful({"", "it never answered", std::nullopt}));
  EXPECT_TRUE(is_doubtful({"not a number\n", "", 0}));
}

}  // namespace
}  // namespace softwall::campaign
