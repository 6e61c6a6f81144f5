#include "campaign/runner/campaign_lock.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <optional>
#include <thread>

#include <nlohmann/json.hpp>

#include "campaign/system/process_identity.hpp"
#include "solver/case/bad_input.hpp"
#include "solver/run_directory/build_info.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/without_permission.hpp"

namespace softwall::campaign {
namespace {

/// A child that takes the lock, tells so through a pipe, and keeps it.
class Holder {
 public:
  explicit Holder(const std::filesystem::path& folder)
      : ends_(make_pipe()), child_([this, folder] {
          const CampaignLock lock(folder);
          if (write(ends_[1], "x", 1) != 1) return 1;
          while (true) pause();
        }) {
    char ready = 0;
    EXPECT_EQ(read(ends_[0], &ready, 1), 1);
  }
  ~Holder() {
    close(ends_[0]);
    close(ends_[1]);
  }
  test::ChildProcess& process() { return child_; }

 private:
  static std::array<int, 2> make_pipe() {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe(ends.data()), 0);
    return ends;
  }
  std::array<int, 2> ends_;
  test::ChildProcess child_;
};

TEST(CampaignLock, ASecondRunnerIsToldWhoHoldsIt) {
  const test::TemporaryFolder folder;
  Holder holder(folder.path());
  try {
    const CampaignLock second(folder.path());
    FAIL() << "two runners hold one campaign";
  } catch (const CampaignOwned& owned) {
    const std::string message = owned.what();
    EXPECT_NE(message.find(std::to_string(holder.process().pid())), std::string::npos) << message;
    EXPECT_NE(message.find(host_name()), std::string::npos) << message;
  }
  EXPECT_TRUE(living_owner(folder.path()).has_value());
}

TEST(CampaignLock, AHolderThatNoListOfProcessesShowsIsSeenByItsLock) {
  const test::TemporaryFolder folder;
  Holder holder(folder.path());
  ProcessIdentity elsewhere = this_process();
  elsewhere.host = "another-host";
  elsewhere.pid = 4000000;
  std::ofstream(folder.path() / "campaign.lock")
      << nlohmann::json{{"process", elsewhere}, {"since", "today"}}.dump();
  EXPECT_EQ(living_owner(folder.path()), "softwall on another-host, process 4000000, started today");
}

TEST(CampaignLock, WhoeverOnlyAsksDoesNotKeepARunnerOut) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("campaign.lock", "");
  test::ChildProcess asking([&] {
    const int lock = open(file.c_str(), O_RDONLY);
    flock(lock, LOCK_SH);
    usleep(100'000);
    return 0;
  });
  usleep(30'000);
  EXPECT_NO_THROW(CampaignLock{folder.path()});
}

TEST(CampaignLock, IsForThisUserOnlyAndNoLink) {
  const test::TemporaryFolder folder;
  folder.write("campaign.lock", "");
  std::filesystem::permissions(folder.path() / "campaign.lock", std::filesystem::perms(0644));
  { const CampaignLock lock(folder.path()); }
  EXPECT_EQ(std::filesystem::status(folder.path() / "campaign.lock").permissions(),
            std::filesystem::perms(0600));

  const auto target = folder.write("precious", "text");
  std::filesystem::remove(folder.path() / "campaign.lock");
  std::filesystem::create_symlink(target, folder.path() / "campaign.lock");
  EXPECT_THROW(CampaignLock{folder.path()}, BadInput);
  EXPECT_EQ(std::filesystem::file_size(target), 4U);
}

TEST(CampaignLock, OfWhatWasRefusedLeavesNoTrace) {
  const test::TemporaryFolder folder;
  {
    CampaignLock lock(folder.path());
    lock.leave_no_trace();
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
  folder.write("campaign.lock", "of an earlier run");
  CampaignLock lock(folder.path());
  lock.leave_no_trace();
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "campaign.lock")) << "it was there before";
}

/// Two who wait for the same lock must not come to hold two files of one name.
TEST(CampaignLock, WhoWaitedForARemovedFileTakesTheOneThatIsThere) {
  const test::TemporaryFolder folder;
  auto first = std::make_unique<CampaignLock>(folder.path());
  std::thread waiting([&] {
    std::optional<CampaignLock> second;
    while (!second) try {
        second.emplace(folder.path());
      } catch (const CampaignOwned&) {  // on a busy machine the first may hold it for long
      }
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "campaign.lock"));
    EXPECT_THROW(CampaignLock{folder.path()}, CampaignOwned);
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  first->leave_no_trace();
  first.reset();
  waiting.join();
}

TEST(CampaignLock, OfAnotherUserTellsNobodyWhoHoldsIt) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(owner_is_unknown(folder.path()));
  const CampaignLock lock(folder.path());
  EXPECT_FALSE(owner_is_unknown(folder.path()));
  const test::WithoutPermission nobody(folder.path() / "campaign.lock");
  EXPECT_TRUE(owner_is_unknown(folder.path()));
  EXPECT_FALSE(living_owner(folder.path()).has_value());
}

TEST(CampaignLock, DiesWithItsHolder) {
  const test::TemporaryFolder folder;
  Holder holder(folder.path());
  holder.process().send(SIGKILL);
  holder.process().wait();
  EXPECT_FALSE(living_owner(folder.path()).has_value());
  EXPECT_NO_THROW(CampaignLock{folder.path()});
}

TEST(CampaignLock, AStaleOrDamagedRecordDoesNotMatter) {
  const test::TemporaryFolder folder;
  ProcessIdentity init = this_process();
  init.pid = 1;  // alive, but not with that start time: a number used again
  folder.write("campaign.lock", nlohmann::json{{"process", init}, {"since", "long ago"}}.dump());
  EXPECT_FALSE(living_owner(folder.path()).has_value());
  EXPECT_NO_THROW(CampaignLock{folder.path()});
  folder.write("campaign.lock", "\x01\x02 not json");
  EXPECT_FALSE(living_owner(folder.path()).has_value());
  EXPECT_NO_THROW(CampaignLock{folder.path()});
}

TEST(CampaignLock, IsNotKeptByAProgramTheHolderStarted) {
  const test::TemporaryFolder folder;
  std::optional<CampaignLock> lock;
  lock.emplace(folder.path());
  test::ChildProcess solver([] {
    execl("/bin/sleep", "sleep", "60", nullptr);
    return 127;
  });
  // exec closes what must not be inherited; wait until it has happened
  const std::string link = "/proc/" + std::to_string(solver.pid()) + "/exe";
  for (int i = 0; i < 200 && std::filesystem::read_symlink(link).filename() == "campaign_runner_tests"; ++i) {
    usleep(10000);
  }
  lock.reset();
  EXPECT_NO_THROW(CampaignLock{folder.path()});
}

TEST(CampaignLock, SaysWhenTheFolderCannotBeWritten) {
  EXPECT_THROW(CampaignLock("/proc/no-such-folder"), std::runtime_error);
}

}  // namespace
}  // namespace softwall::campaign
