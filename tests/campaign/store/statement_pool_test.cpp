#include <gtest/gtest.h>

#include "campaign/store/sqlite.hpp"

namespace softwall::campaign {
namespace {

class StatementPoolTest : public ::testing::Test {
 protected:
  void SetUp() override {
    connection.execute(
        "CREATE TABLE t (i INTEGER PRIMARY KEY, s TEXT); INSERT INTO t VALUES (1, 'a'), (2, 'b')");
  }
  std::string text_of(int i) {
    Statement rows = connection.query("SELECT s FROM t WHERE i = ?", i);
    return rows.step() ? rows.text(0) : "none";
  }
  Connection connection = Connection::open_in_memory();
};

TEST_F(StatementPoolTest, AStatementIsUsedAgainWithOtherValues) {
  Statement first = connection.query("SELECT s FROM t WHERE i = ?", 1);
  const auto* const handle = first.handle();
  EXPECT_TRUE(first.step());
  { const Statement gone = std::move(first); }
  Statement again = connection.query("SELECT s FROM t WHERE i = ?", 2);
  EXPECT_EQ(again.handle(), handle);
  ASSERT_TRUE(again.step());
  EXPECT_EQ(again.text(0), "b");
}

TEST_F(StatementPoolTest, OneInsideAnotherIsAnother) {
  Statement outer = connection.query("SELECT i FROM t WHERE i > ? ORDER BY i", 0);
  std::string seen;
  while (outer.step()) {
    Statement inner = connection.query("SELECT i FROM t WHERE i > ? ORDER BY i", 1);
    while (inner.step()) seen += std::to_string(outer.integer(0)) + std::to_string(inner.integer(0)) + " ";
  }
  EXPECT_EQ(seen, "12 22 ");
}

TEST_F(StatementPoolTest, AFailureLeavesNothingBehind) {
  for (int attempt = 0; attempt < 2; ++attempt)
    EXPECT_THROW(connection.run("INSERT INTO t VALUES (?, ?)", 1, "again"), SqliteError);
  connection.run("INSERT INTO t VALUES (?, ?)", 3, "c");
  EXPECT_EQ(text_of(3), "c");
  EXPECT_EQ(text_of(4), "none");
}

/// What is kept takes no lock and survives a change of the schema.
TEST_F(StatementPoolTest, TablesMayChange) {
  EXPECT_EQ(text_of(1), "a");
  connection.execute("ALTER TABLE t ADD COLUMN more TEXT; DROP TABLE t; CREATE TABLE t (i INTEGER, s TEXT)");
  EXPECT_EQ(text_of(1), "none");
}

}  // namespace
}  // namespace softwall::campaign
