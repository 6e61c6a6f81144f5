#include "campaign/store/query.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/campaign/store/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign::tests {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

class QueryTest : public ::testing::Test {
 protected:
  void SetUp() override { Store::open(folder.path(), OpenMode::kCreate).record_campaign(paper_campaign()); }
  ResultTable ask(const std::string& sql) const {
    Connection store = open_store_file(folder.path(), OpenMode::kReadOnly);
    return run_query(store, sql);
  }
  std::string refused(const std::string& sql) const {
    return refusal([&] { (void)ask(sql); });
  }
  test::TemporaryFolder folder;
};

TEST_F(QueryTest, GivesEveryTypeAsItIs) {
  const ResultTable table = ask("SELECT 1 AS i, 2.5 AS r, 'x' AS t, NULL AS n, x'41' AS b");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"i", "r", "t", "n", "b"}));
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0][0], Cell(std::int64_t{1}));
  EXPECT_EQ(table.rows[0][1], Cell(2.5));
  EXPECT_EQ(table.rows[0][2], Cell(std::string("x")));
  EXPECT_EQ(table.rows[0][3], Cell(std::monostate{}));
  EXPECT_EQ(table.rows[0][4], Cell(std::string("A")));
}

TEST_F(QueryTest, ReadsWhateverAResearcherMayWant) {
  for (const char* sql :
       {"SELECT label, re_tau FROM results WHERE G >= 1 ORDER BY re_tau DESC", "SELECT * FROM documentation",
        "SELECT * FROM timeline;", "-- comment first\nSELECT * FROM progress; -- and last\n",
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 5) SELECT avg(i) FROM n",
        "SELECT json_extract(physics, '$.grid.nx') FROM cases", "SELECT key FROM cases, json_each(physics)",
        "EXPLAIN QUERY PLAN SELECT * FROM results", "PRAGMA table_info(results)",
        "SELECT name FROM pragma_table_info('cases')", "SELECT name, sql FROM sqlite_schema",
        "VALUES (1), (2)"}) {
    EXPECT_EQ(refused(sql), "") << sql;
  }
  Connection store = open_store_file(folder.path(), OpenMode::kReadOnly);
  EXPECT_EQ(export_results(store).rows.size(), 7U);
}

TEST_F(QueryTest, ChangesNothing) {
  for (const char* sql : {"DELETE FROM cases",
                          "UPDATE cases SET label = 'x'",
                          "INSERT INTO campaign VALUES (2, '', '', '', '')",
                          "DROP TABLE cases",
                          "CREATE TABLE t (x)",
                          "CREATE TEMP TABLE t (x)",
                          "VACUUM",
                          "VACUUM INTO '/tmp/stolen.db'",
                          "REINDEX",
                          "ANALYZE",
                          "BEGIN",
                          "BEGIN IMMEDIATE",
                          "COMMIT",
                          "SAVEPOINT s",
                          "ATTACH '/tmp/other.db' AS o",
                          "ATTACH ':memory:' AS m",
                          "DETACH main",
                          "PRAGMA user_version = 7",
                          "PRAGMA journal_mode = DELETE",
                          "PRAGMA writable_schema = 1",
                          "PRAGMA query_only = 0",
                          "PRAGMA wal_checkpoint(TRUNCATE)",
                          "WITH x AS (SELECT 1) DELETE FROM cases",
                          "EXPLAIN DELETE FROM cases",
                          "SELECT load_extension('evil')"}) {
    EXPECT_THAT(refused(sql),
                AnyOf(HasSubstr("only read"), HasSubstr("not authorized"), HasSubstr("may not be modified")))
        << sql;
  }
  EXPECT_EQ(ask("SELECT * FROM cases").rows.size(), 7U);
}

TEST_F(QueryTest, TakesOneStatement) {
  EXPECT_THAT(refused("SELECT 1; SELECT 2"), HasSubstr("one SQL statement"));
  EXPECT_THAT(refused("SELECT 1; DROP TABLE cases"), HasSubstr("one SQL statement"));
  EXPECT_THAT(refused("SELECT 1; nonsense"), HasSubstr("one SQL statement"));
  EXPECT_THAT(refused(""), HasSubstr("empty"));
  EXPECT_THAT(refused(" ; -- nothing"), HasSubstr("empty"));
  EXPECT_THAT(refused(std::string("SELECT 1\0; DROP TABLE cases", 27)), HasSubstr("NUL"));
}

TEST_F(QueryTest, SaysWhatIsWrongWithTheSql) {
  EXPECT_THAT(refused("SELECT re_tou FROM results"), HasSubstr("no such column: re_tou"));
  EXPECT_THAT(refused("SELEC 1"), HasSubstr("syntax error"));
  EXPECT_THAT(refused("SELECT \"no column\" FROM cases"), HasSubstr("no such column"));
  EXPECT_THAT(refused("SELECT 'unfinished"), HasSubstr("unrecognized token"));
}

TEST_F(QueryTest, SuggestsWhatWasProbablyMeant) {
  Connection store = open_store_file(folder.path(), OpenMode::kReadOnly);
  const auto advice = [&](const std::string& sql) { return advice_for_query(store, refused(sql)); };
  EXPECT_EQ(advice("SELECT re_tou FROM results"), "did you mean re_tau?");
  EXPECT_EQ(advice("SELECT results.RE_TAU_X FROM results"), "did you mean re_tau_w?");
  EXPECT_EQ(advice("SELECT * FROM resulst"), "did you mean results?");
  EXPECT_THAT(advice("SELECT completely_else FROM results"), HasSubstr("FROM documentation"));
  EXPECT_EQ(advice("SELEC 1"), "one SQL statement that reads");
}

}  // namespace
}  // namespace softwall::campaign::tests
