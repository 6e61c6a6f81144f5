#include "tests/campaign/launch/slurm_launcher_fixture.hpp"

namespace softwall::campaign {
namespace {

using namespace slurm_tests;

/// A folder that was copied or moved, with all its files, after its job had been submitted.
class SlurmFolderTest : public SlurmLauncherTest {
 protected:
  SlurmFolderTest() : handle_(launcher_.start(request())) {}
  [[nodiscard]] LaunchRequest request_there() const { return {kCase, there_.directory, 1, 2, std::nullopt}; }

  RunFiles there_{folder_.path() / "there" / "one-01234567"};
  Handle handle_;
  SlurmLauncher next_{options_, test::kQuickPace};
};

TEST_F(SlurmFolderTest, TheJobOfAFolderIsNotThatOfItsCopy) {
  std::filesystem::copy(folder_.path() / "cases", folder_.path() / "there",
                        std::filesystem::copy_options::recursive);
  slurm_.move_all("RUNNING");
  EXPECT_EQ(next_.presence(there_.directory, handle_), Presence::kGone);
  EXPECT_FALSE(next_.adopt(request_there(), handle_));
  for (const StopLevel level : {StopLevel::kCheckpoint, StopLevel::kTerminate, StopLevel::kKill})
    next_.stop(there_.directory, handle_, level);
  EXPECT_TRUE(slurm_.calls("scancel").empty());
  EXPECT_EQ(next_.presence(run_.directory, handle_), Presence::kRunning) << "the original keeps it";
}

TEST_F(SlurmFolderTest, TheJobOfAFolderThatWasMovedIsWaitedForAndNotEnded) {
  std::filesystem::rename(folder_.path() / "cases", folder_.path() / "there");
  slurm_.move_all("RUNNING");
  EXPECT_EQ(next_.presence(there_.directory, handle_), Presence::kUnknown);
  ASSERT_TRUE(next_.adopt(request_there(), handle_));
  EXPECT_EQ(next_.news().size(), 1U);
  slurm_.set_queue({slurm_.queue().front(), "9|PENDING|0|Dependency|" + job_name(request()) + "|"});
  EXPECT_FALSE(collect_once(next_));
  EXPECT_EQ(next_.presence(there_.directory, handle_), Presence::kUnknown)
      << "nor is it taken for one that hangs";
  next_.stop(there_.directory, handle_, StopLevel::kKill);
  EXPECT_TRUE(slurm_.calls("scancel").empty());
  slurm_.move_all("FAILED", 1 << 8);
  const auto ended = collect_once(next_);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit_code, 1);
}

TEST_F(SlurmFolderTest, AnotherPathToTheSameFolderFindsItsJob) {
  std::filesystem::rename(folder_.path() / "cases", folder_.path() / "there");
  std::filesystem::create_directory_symlink("there", folder_.path() / "cases");
  EXPECT_EQ(next_.presence(there_.directory, handle_), Presence::kQueued);
  EXPECT_TRUE(next_.adopt(request_there(), handle_));
  next_.stop(there_.directory, handle_, StopLevel::kTerminate);
  EXPECT_EQ(slurm_.calls("scancel").size(), 1U);
}

}  // namespace
}  // namespace softwall::campaign
