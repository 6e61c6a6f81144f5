#include "campaign/store/store_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <sstream>

#include "campaign/store/store_schema.hpp"
#include "tests/campaign/store/examples.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign::tests {
namespace {

using std::filesystem::path;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string bytes_of(const path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

class StoreFileTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder;
  path file = folder.path() / "results.db";

  std::string refused(OpenMode mode) const {
    return refusal([&] { (void)Store::open(folder.path(), mode); });
  }
  /// In every mode, with the same words, and the file stays as it was.
  void expect_refused(const std::string& words) const {
    const std::string before = bytes_of(file);
    for (const OpenMode mode : {OpenMode::kReadOnly, OpenMode::kReadWrite, OpenMode::kCreate}) {
      EXPECT_THAT(refused(mode), AllOf(HasSubstr(file.string()), HasSubstr(words)));
      EXPECT_EQ(bytes_of(file), before);
    }
  }
  void make_store() const {
    Store store = Store::open(folder.path(), OpenMode::kCreate);
    store.record_campaign(paper_campaign());
  }
  void run_sql(const std::string& sql) const { Connection::open(file, Access::kReadWrite).execute(sql); }
};

TEST_F(StoreFileTest, IsMadeOnlyWhenAskedFor) {
  EXPECT_THAT(refused(OpenMode::kReadOnly), HasSubstr("no results store here"));
  EXPECT_THAT(refused(OpenMode::kReadWrite), HasSubstr("no results store here"));
  EXPECT_FALSE(std::filesystem::exists(file));
  make_store();
  EXPECT_EQ(refused(OpenMode::kReadWrite), "");
  EXPECT_EQ(refused(OpenMode::kReadOnly), "");
  EXPECT_THAT(refusal([&] { (void)Store::open(folder.path() / "nowhere", OpenMode::kCreate); }),
              HasSubstr("no such campaign directory"));
}

TEST_F(StoreFileTest, LeavesNothingBesideItWhenClosed) {
  make_store();
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
  EXPECT_EQ(files, 1U);
}

TEST_F(StoreFileTest, OpeningAgainKeepsTheRows) {
  make_store();
  EXPECT_EQ(number_of_cases(Store::open(folder.path(), OpenMode::kCreate)), 7U);
  EXPECT_EQ(number_of_cases(Store::open(folder.path(), OpenMode::kReadWrite)), 7U);
  EXPECT_EQ(number_of_cases(Store::open(folder.path(), OpenMode::kReadOnly)), 7U);
}

TEST_F(StoreFileTest, NamesWithAMeaningInUrisAreNames) {
  const path odd = folder.path() / "50% of #1 ?mode=memory & 'x'";
  std::filesystem::create_directory(odd);
  Store::open(odd, OpenMode::kCreate).record_campaign(paper_campaign());
  EXPECT_TRUE(std::filesystem::exists(odd / "results.db"));
  EXPECT_EQ(number_of_cases(Store::open(odd, OpenMode::kReadOnly)), 7U);
}

TEST_F(StoreFileTest, RefusesAnEmptyFile) {
  folder.write("results.db", "");
  expect_refused("is empty (0 bytes)");
}

TEST_F(StoreFileTest, RefusesGarbage) {
  folder.write("results.db", std::string(8192, 'x'));
  expect_refused("no results store");
  folder.write("results.db", "hello");
  expect_refused("no results store");
  folder.write("results.db", "x");
  expect_refused("holds nothing (1 bytes)");
}

TEST_F(StoreFileTest, RefusesADirectoryOfThatName) {
  std::filesystem::create_directory(file);
  EXPECT_THAT(refused(OpenMode::kCreate), HasSubstr("is not a file"));
}

TEST_F(StoreFileTest, RefusesAForeignDatabase) {
  folder.write("results.db", "");
  run_sql("CREATE TABLE precious (x); PRAGMA user_version = 1");
  expect_refused("no results store of softwall");
  run_sql("PRAGMA journal_mode = WAL");
  expect_refused("no results store of softwall");
}

TEST_F(StoreFileTest, RefusesANewerFormatNamingBoth) {
  make_store();
  run_sql("PRAGMA user_version = 999");
  expect_refused("store format 999 was made by a newer softwall; this one knows formats up to " +
                 std::to_string(kSchemaVersion));
}

TEST_F(StoreFileTest, RefusesATruncatedFile) {
  make_store();
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_THAT(refused(OpenMode::kReadWrite), AllOf(HasSubstr(file.string()), HasSubstr("damaged")));
}

TEST_F(StoreFileTest, RefusesDamagedPagesBeforeWriting) {
  make_store();
  std::fstream damage(file, std::ios::binary | std::ios::in | std::ios::out);
  damage.seekp(static_cast<std::streamoff>(std::filesystem::file_size(file)) - 4096 * 6);
  damage << std::string(4096, '\x5a');
  damage.close();
  EXPECT_THAT(refused(OpenMode::kReadWrite), AllOf(HasSubstr(file.string()), HasSubstr("damaged")));
}

TEST_F(StoreFileTest, DoesNotMakeANewStoreOverTheLogOfALostOne) {
  folder.write("results.db-wal", "frames");
  EXPECT_THAT(refused(OpenMode::kCreate), HasSubstr("is gone, but its -wal"));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(StoreFileTest, WritesSafely) {
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  const bool log = journal_mode_for(folder.path()) == JournalMode::kWriteAheadLog;
  EXPECT_EQ(answer(store, "PRAGMA journal_mode"), log ? "wal" : "delete");
  EXPECT_EQ(answer(store, "PRAGMA synchronous"), log ? "2" : "3");
  EXPECT_EQ(answer(store, "PRAGMA foreign_keys"), "1");
  EXPECT_NE(answer(store, "PRAGMA busy_timeout"), "0");
  set_up_for_writing(store.connection(), JournalMode::kRollback);
  EXPECT_EQ(answer(store, "PRAGMA journal_mode"), "delete");
}

TEST_F(StoreFileTest, ReadersDoNotWaitForAWriter) {
  Store writer = Store::open(folder.path(), OpenMode::kCreate);
  writer.record_campaign(paper_campaign());
  Transaction unfinished(writer.connection());
  writer.connection().run("UPDATE cases SET label = 'x'");
  if (journal_mode_for(folder.path()) == JournalMode::kWriteAheadLog) {
    Store reader = Store::open(folder.path(), OpenMode::kReadOnly);
    EXPECT_EQ(answer(reader, "SELECT count(*) FROM cases WHERE label = 'x'"), "0");
  }
}

TEST_F(StoreFileTest, ASecondWriterIsToldWhy) {
  Store writer = Store::open(folder.path(), OpenMode::kCreate);
  Store second = Store::open(folder.path(), OpenMode::kReadWrite);
  sqlite3_busy_timeout(second.connection().handle(), 50);
  Transaction unfinished(writer.connection());
  EXPECT_THAT(refusal([&] { second.record_campaign(paper_campaign()); }),
              AllOf(HasSubstr(file.string()), HasSubstr("another program holds the store")));
}

TEST_F(StoreFileTest, AReaderCannotWrite) {
  make_store();
  Store reader = Store::open(folder.path(), OpenMode::kReadOnly);
  const Campaign another = campaign_with(paper_campaign().cases.front());  // the same one needs no writing
  EXPECT_THAT(refusal([&] { reader.record_campaign(another); }), HasSubstr("readonly"));
}

// A rollback journal left by kill -9 must be played back before anybody reads.
TEST_F(StoreFileTest, ReadsAfterACrashWithARollbackJournal) {
  make_store();
  test::ChildProcess writer([&] {
    Connection connection = Connection::open(file, Access::kReadWrite);
    set_up_for_writing(connection, JournalMode::kRollback);
    connection.execute("PRAGMA cache_spill = 1; PRAGMA cache_size = 2; BEGIN IMMEDIATE");
    connection.execute(
        "UPDATE cases SET label = hex(randomblob(20000))");  // larger than the cache: reaches the disk
    kill(getpid(), SIGKILL);
    return 0;
  });
  writer.wait();
  ASSERT_TRUE(std::filesystem::exists(file.string() + "-journal"));
  Store reader = Store::open(folder.path(), OpenMode::kReadOnly);
  EXPECT_EQ(answer(reader, "SELECT label FROM cases WHERE is_precursor"), "precursor");
}

// Runs as nobody when we are root, because root may write anywhere.
class ReadOnlyFolderTest : public StoreFileTest {
 protected:
  void SetUp() override {
    make_store();
    std::filesystem::permissions(file, std::filesystem::perms(0444));
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  }
  void TearDown() override { std::filesystem::permissions(folder.path(), std::filesystem::perms(0755)); }

  /// 0 when check holds for a user without permission to write.
  static int as_nobody(const std::function<bool()>& check) {
    test::ChildProcess child([&] {
      constexpr uid_t kNobody = 65534;
      if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) return 2;
      return check() ? 0 : 1;
    });
    return WEXITSTATUS(child.wait());
  }
};

TEST_F(ReadOnlyFolderTest, CanBeRead) {
  EXPECT_EQ(as_nobody([&] { return number_of_cases(Store::open(folder.path(), OpenMode::kReadOnly)) == 7; }),
            0);
  EXPECT_EQ(as_nobody([&] {
              Connection store = open_store_file(folder.path(), OpenMode::kReadOnly);
              return run_query(store, "SELECT * FROM results").rows.size() == 7;
            }),
            0);
}

TEST_F(ReadOnlyFolderTest, WritingIsRefusedInWords) {
  EXPECT_EQ(
      as_nobody([&] { return refused(OpenMode::kReadWrite).find("write-protected") != std::string::npos; }),
      0);
}

TEST_F(ReadOnlyFolderTest, ANewStoreIsRefusedInWords) {
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  std::filesystem::remove(file);
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  EXPECT_EQ(as_nobody([&] {
              return refused(OpenMode::kCreate).find("cannot create the results store") != std::string::npos;
            }),
            0);
}

TEST_F(ReadOnlyFolderTest, RowsThatWouldBeOverlookedAreNotOverlooked) {
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  folder.write("results.db-wal", "frames");
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  EXPECT_EQ(as_nobody([&] {
              return refused(OpenMode::kReadOnly).find("has to be completed first") != std::string::npos;
            }),
            0);
}

}  // namespace
}  // namespace softwall::campaign::tests
