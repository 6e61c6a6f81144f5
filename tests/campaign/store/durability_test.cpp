#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/mount.h>

#include <chrono>
#include <random>
#include <thread>

#include "campaign/store/store_file.hpp"
#include "tests/campaign/store/examples.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

/// What was acknowledged is there: after kill -9 at any moment, and when the disk is full.
namespace softwall::campaign::tests {
namespace {

using std::filesystem::path;
using ::testing::HasSubstr;

class Pipe {
 public:
  Pipe() {
    if (pipe(ends_) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    close_writer();
    close(ends_[0]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_writer() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  void send(int number) const { EXPECT_EQ(write(ends_[1], &number, sizeof number), ssize_t{sizeof number}); }
  /// The next number; 0 when the writer is dead.
  [[nodiscard]] int receive() const {
    int number = 0;
    return read(ends_[0], &number, sizeof number) == ssize_t{sizeof number} ? number : 0;
  }

 private:
  int ends_[2] = {-1, -1};
};

/// Writes attempt after attempt, each with its end, and tells the number of every one that is acknowledged.
int write_attempts(const path& folder, const std::string& id, JournalMode journal, const Pipe& acknowledged) {
  Store store = Store::open(folder, OpenMode::kReadWrite);
  set_up_for_writing(store.connection(), journal);
  for (;;) {
    const int attempt = store.begin_attempt(id, {"here", 1, ""});
    AttemptEnd end = failed_at(attempt);
    end.diagnostics = {{"a", attempt}, {"b", -attempt}};
    store.end_attempt(id, attempt, end);
    acknowledged.send(attempt);
  }
}

class KillTest : public ::testing::TestWithParam<JournalMode> {};

TEST_P(KillTest, LosesNoAcknowledgedRow) {
  test::TemporaryFolder folder;
  const Campaign campaign = paper_campaign();
  const std::string id = campaign.cases.back().definition.id;
  Store::open(folder.path(), OpenMode::kCreate).record_campaign(campaign);
  std::mt19937 random(20240501);
  std::uniform_int_distribution<int> patience(0, 4), microseconds(0, 30'000);
  int known = 0;
  for (int round = 0; round < 25; ++round) {
    Pipe acknowledged;
    test::ChildProcess writer([&] { return write_attempts(folder.path(), id, GetParam(), acknowledged); });
    acknowledged.close_writer();
    for (int wait = patience(random); wait > 0; --wait) known = acknowledged.receive();
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    writer.send(SIGKILL);
    writer.wait();
    for (int number = acknowledged.receive(); number > 0; number = acknowledged.receive()) known = number;

    Store store = Store::open(folder.path(), OpenMode::kReadWrite);  // runs quick_check
    EXPECT_EQ(answer(store, "PRAGMA integrity_check"), "ok");
    const std::string count = "SELECT count(*) FROM attempts WHERE ended IS NOT NULL AND attempt <= ";
    EXPECT_EQ(answer(store, count + std::to_string(known)), std::to_string(known)) << "round " << round;
    // An attempt and its diagnostics are one change: both or neither.
    EXPECT_EQ(answer(store,
                     "SELECT count(*) FROM attempts a WHERE (ended IS NOT NULL) <> (2 = (SELECT count(*)"
                     " FROM diagnostics d WHERE d.attempt = a.attempt AND abs(d.value) = a.attempt))"),
              "0");
    for (const OpenAttempt& open : store.open_attempts(id))
      store.end_attempt(id, open.attempt, [&] {
        AttemptEnd end = failed_at(open.attempt);
        end.diagnostics = {{"a", open.attempt}, {"b", -open.attempt}};
        return end;
      }());
  }
  EXPECT_GT(known, 25);
}

INSTANTIATE_TEST_SUITE_P(BothJournals, KillTest,
                         ::testing::Values(JournalMode::kWriteAheadLog, JournalMode::kRollback),
                         [](const auto& test) {
                           return test.param == JournalMode::kRollback ? "Rollback" : "WriteAheadLog";
                         });

TEST(CreationTest, KilledAtAnyMomentLeavesNoneOrAWholeStore) {
  for (int round = 0; round < 25; ++round) {
    test::TemporaryFolder folder;
    test::ChildProcess maker([&] {
      (void)Store::open(folder.path(), OpenMode::kCreate);
      return 0;
    });
    std::this_thread::sleep_for(std::chrono::microseconds(300 * round));
    maker.send(SIGKILL);
    maker.wait();
    EXPECT_EQ(refusal([&] { (void)Store::open(folder.path(), OpenMode::kCreate); }), "") << round;
  }
}

TEST(CreationTest, OfTwentyAtOnceAllGetTheSameStore) {
  test::TemporaryFolder folder;
  const Campaign campaign = paper_campaign();
  std::vector<std::unique_ptr<test::ChildProcess>> makers;
  for (int i = 0; i < 20; ++i) {
    makers.push_back(std::make_unique<test::ChildProcess>([&folder, &campaign, i] {
      const std::string why = refusal([&] {
        Store store = Store::open(folder.path(), OpenMode::kCreate);
        store.record_campaign(campaign_with(campaign.cases[static_cast<std::size_t>(i) % 7]));
      });
      std::fputs(why.c_str(), stderr);
      return why.empty() ? 0 : 1;
    }));
  }
  for (auto& maker : makers) EXPECT_EQ(maker->wait(), 0);
  EXPECT_EQ(number_of_cases(Store::open(folder.path(), OpenMode::kReadOnly)), 7U);
}

/// Fills the store until it is refused; returns the attempts that were acknowledged.
int write_until_full(Store& store, const std::string& id, std::string& refused) {
  int acknowledged = 0;
  refused = refusal([&] {
    for (int i = 0; i < 100'000; ++i) {
      AttemptEnd end = failed_at(i);
      end.reason = std::string(500, 'x');
      store.restore_attempt(id, i + 1, {"here", 1, ""}, end);
      acknowledged = i + 1;
    }
  });
  return acknowledged;
}

TEST(FullDiskTest, IsReportedKeepsWhatWasAcknowledgedAndEnds) {
  test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  const Campaign campaign = paper_campaign();
  store.record_campaign(campaign);
  const std::string id = campaign.cases.back().definition.id;
  (void)answer(store, "PRAGMA max_page_count = 80");
  std::string refused;
  const int acknowledged = write_until_full(store, id, refused);
  EXPECT_THAT(refused, HasSubstr("disk is full"));
  EXPECT_GT(acknowledged, 0);
  EXPECT_EQ(store.attempts(id), acknowledged);
  EXPECT_EQ(answer(store, "PRAGMA integrity_check"), "ok");
  (void)answer(store, "PRAGMA max_page_count = 100000");
  EXPECT_EQ(store.begin_attempt(id, {"here", 1, ""}), acknowledged + 1);
}

/// A file system of a few pages; only root can have one.
class SmallDisk {
 public:
  SmallDisk() : mounted_(mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, "size=1m") == 0) {}
  ~SmallDisk() {
    if (mounted_) umount(folder_.path().c_str());
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  [[nodiscard]] bool mounted() const { return mounted_; }
  [[nodiscard]] const path& folder() const { return folder_.path(); }
  [[nodiscard]] bool grow() const {
    return mount("tmpfs", folder_.path().c_str(), "tmpfs", MS_REMOUNT, "size=8m") == 0;
  }

 private:
  test::TemporaryFolder folder_;
  bool mounted_;
};

TEST(FullDiskTest, ARealOneGoesOnWhenThereIsSpaceAgain) {
  const SmallDisk disk;
  if (!disk.mounted()) GTEST_SKIP() << "needs the right to mount a tmpfs";
  const Campaign campaign = paper_campaign();
  const std::string id = campaign.cases.back().definition.id;
  std::string refused;
  int acknowledged = 0;
  {
    Store store = Store::open(disk.folder(), OpenMode::kCreate);
    store.record_campaign(campaign);
    acknowledged = write_until_full(store, id, refused);
    EXPECT_EQ(store.attempts(id), acknowledged);
  }
  EXPECT_NE(refused, "");
  EXPECT_GT(acknowledged, 10);
  ASSERT_TRUE(disk.grow());
  Store store = Store::open(disk.folder(), OpenMode::kReadWrite);
  EXPECT_EQ(store.attempts(id), acknowledged);
  EXPECT_EQ(answer(store, "PRAGMA integrity_check"), "ok");
  EXPECT_EQ(store.begin_attempt(id, {"here", 1, ""}), acknowledged + 1);
}

}  // namespace
}  // namespace softwall::campaign::tests
