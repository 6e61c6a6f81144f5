#include "campaign/store/backup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/campaign/store/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign::tests {
namespace {

using ::testing::HasSubstr;

TEST(BackupTest, OfALiveStoreIsAWholeStore) {
  test::TemporaryFolder folder;
  Store live = Store::open(folder.path(), OpenMode::kCreate);
  live.record_campaign(paper_campaign());  // still in the write-ahead log
  std::filesystem::create_directory(folder.path() / "copy");
  backup_connection(live.connection(), folder.path() / "copy" / "results.db");
  live.set_state(paper_campaign().cases.front().definition.id, CaseState::kFinished, "later");

  Store copy = Store::open(folder.path() / "copy", OpenMode::kReadWrite);
  EXPECT_EQ(answer(copy, "SELECT count(*) FROM cases WHERE state = 'new'"), "7");
  EXPECT_EQ(answer(copy, "PRAGMA integrity_check"), "ok");
}

TEST(BackupTest, ReplacesNoFile) {
  test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  store.record_campaign(paper_campaign());
  const auto taken = folder.write("taken.db", "precious");
  EXPECT_THAT(refusal([&] { backup_connection(store.connection(), taken); }), HasSubstr("exists already"));
  EXPECT_EQ(std::filesystem::file_size(taken), 8U);
  EXPECT_THROW(backup_connection(store.connection(), folder.path() / "no" / "such" / "folder.db"),
               std::system_error);
}

}  // namespace
}  // namespace softwall::campaign::tests
