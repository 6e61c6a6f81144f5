#include "campaign/store/store_schema.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "campaign/core/words.hpp"
#include "campaign/store/store_documentation.hpp"
#include "campaign/store/store_file.hpp"
#include "schemas/embedded.hpp"
#include "tests/campaign/store/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign::tests {
namespace {

using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> column_of(Connection& connection, const std::string& sql) {
  std::vector<std::string> values;
  Statement rows = connection.prepare(sql);
  while (rows.step()) values.push_back(rows.text(0));
  return values;
}

class SchemaTest : public ::testing::Test {
 protected:
  void SetUp() override { create_schema(connection); }
  Connection connection = Connection::open_in_memory();
};

TEST_F(SchemaTest, EveryColumnOfEveryTableAndViewIsDocumented) {
  EXPECT_THAT(column_of(connection,
                        "SELECT s.name || '.' || c.name FROM sqlite_schema s, pragma_table_xinfo(s.name) c"
                        " WHERE s.type IN ('table', 'view') AND s.name NOT LIKE 'sqlite_%' AND NOT EXISTS"
                        " (SELECT 1 FROM documentation d WHERE d.object = s.name AND d.column_name = c.name"
                        "  AND length(d.meaning) > 3 AND length(d.unit) > 0)"),
              IsEmpty());
  EXPECT_THAT(column_of(connection,
                        "SELECT name FROM sqlite_schema s WHERE type IN ('table', 'view') AND NOT EXISTS"
                        " (SELECT 1 FROM documentation d WHERE d.object = s.name AND d.column_name = ''"
                        "  AND length(d.meaning) > 10)"),
              IsEmpty());
}

TEST_F(SchemaTest, NothingIsDocumentedThatIsNotThere) {
  EXPECT_THAT(
      column_of(connection,
                "SELECT object || '.' || column_name FROM documentation d WHERE column_name <> '' AND NOT"
                " EXISTS (SELECT 1 FROM pragma_table_xinfo(d.object) c WHERE c.name = d.column_name)"),
      IsEmpty());
}

TEST_F(SchemaTest, AColumnWithoutCommentWouldBeNoticed) {
  const auto found = documentation_in(
      "-- Things.\nCREATE TABLE t (\n  a TEXT, -- [m] length of it\n  b TEXT,\n"
      "  c TEXT CHECK (c IN\n    ('x', 'y')), -- [-] two\n  -- words\n) STRICT;\n");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].object + found[0].column + found[0].meaning, "tThings.");
  EXPECT_EQ(found[1].column + "|" + found[1].unit + "|" + found[1].meaning, "a|m|length of it");
  EXPECT_EQ(found[2].column + "|" + found[2].unit + "|" + found[2].meaning, "c|-|two words");
}

TEST_F(SchemaTest, EveryTableIsStrict) {
  EXPECT_THAT(column_of(connection,
                        "SELECT name FROM pragma_table_list WHERE schema = 'main' AND type = 'table'"
                        " AND NOT strict AND name NOT LIKE 'sqlite_%'"),
              IsEmpty());
  EXPECT_THAT(refusal([&] { connection.execute("INSERT INTO campaign VALUES (1, 'n', 's', 'c', x'00')"); }),
              HasSubstr("BLOB"));
}

TEST_F(SchemaTest, TheResultsViewBeginsAsPromised) {
  std::vector<std::string> expected = {"case_id", "label", "G", "viscosity_ratio"};
  for (const auto& [name, member] : analysis::kMeasuredMembers) {
    expected.emplace_back(name);
    expected.push_back(std::string(name) + "_ci95");
  }
  auto columns = column_of(connection, "SELECT name FROM pragma_table_info('results') ORDER BY cid");
  ASSERT_GT(columns.size(), expected.size());
  columns.resize(expected.size());
  EXPECT_THAT(columns, ElementsAreArray(expected));
}

TEST_F(SchemaTest, TheResultsViewPutsEveryNumberInItsColumn) {
  test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  const Campaign campaign = paper_campaign();
  store.record_campaign(campaign);
  double seed = 100.0;
  for (const CampaignCase& each : campaign.cases)
    store.record_result(each.definition.id, result_made_of(seed++), "");
  seed = 100.0;
  for (const CampaignCase& each : campaign.cases) {
    const analysis::DerivedQuantities expected = result_made_of(seed++);
    for (const auto& [name, member] : analysis::kMeasuredMembers) {
      const std::string column(name);
      Statement row = store.connection().query(
          "SELECT " + column + ", " + column + "_ci95 FROM results WHERE case_id = ?", each.definition.id);
      ASSERT_TRUE(row.step());
      EXPECT_EQ(row.real(0), (expected.*member).value) << name;
      EXPECT_EQ(row.real(1), (expected.*member).ci95) << name;
    }
  }
  EXPECT_EQ(answer(store, "SELECT count(*) FROM results"), "7");
  EXPECT_EQ(answer(store, "SELECT G IS NULL AND viscosity_ratio IS NULL FROM results LIMIT 1"), "1");
}

TEST_F(SchemaTest, IdentityAndVersionAreSet) {
  EXPECT_EQ(connection.integer("PRAGMA application_id"), kApplicationId);
  EXPECT_EQ(schema_version(connection), kSchemaVersion);
}

TEST_F(SchemaTest, WordsOfTheProgramAndOfTheTableAgree) {
  for (int value = 0; value <= static_cast<int>(CaseState::kFailed); ++value) {
    const auto state = static_cast<CaseState>(value);
    EXPECT_EQ(state_of(word_of(state)), state);
    EXPECT_THAT(std::string(schemas::kResultsSql), HasSubstr("'" + std::string(word_of(state)) + "'"));
  }
  EXPECT_FALSE(state_of("unheard of").has_value());
}

TEST(Migration, TakesAStoreStepByStepToTheTarget) {
  Connection connection = Connection::open_in_memory();
  create_schema(connection);
  const std::vector<Migration> steps = {
      {kSchemaVersion, "ALTER TABLE campaign ADD COLUMN first TEXT; UPDATE campaign SET first = 'done'"},
      {kSchemaVersion + 1, "ALTER TABLE campaign ADD COLUMN second TEXT"}};
  connection.execute(
      "INSERT INTO campaign (id, name, spec, created, updated) VALUES (1, 'n', 's', 'c', 'u')");
  migrate(connection, steps, kSchemaVersion + 2);
  EXPECT_EQ(connection.integer("PRAGMA user_version"), kSchemaVersion + 2);
  EXPECT_EQ(connection.integer("SELECT count(*) FROM campaign WHERE first = 'done' AND second IS NULL"), 1);
  EXPECT_GT(connection.integer("SELECT count(*) FROM documentation"), 0);
  migrate(connection, steps, kSchemaVersion + 2);  // there already
}

TEST(Migration, AFailedStepLeavesTheOldFormat) {
  Connection connection = Connection::open_in_memory();
  create_schema(connection);
  const std::vector<Migration> steps = {{kSchemaVersion, "ALTER TABLE campaign ADD COLUMN first TEXT"},
                                        {kSchemaVersion + 1, "ALTER TABLE nowhere ADD COLUMN second TEXT"}};
  EXPECT_THAT(refusal([&] { migrate(connection, steps, kSchemaVersion + 2); }), HasSubstr("nowhere"));
  EXPECT_EQ(connection.integer("PRAGMA user_version"), kSchemaVersion);
  EXPECT_EQ(connection.integer("SELECT count(*) FROM pragma_table_info('campaign') WHERE name = 'first'"), 0);
  EXPECT_THAT(refusal([&] { migrate(connection, {}, kSchemaVersion + 1); }), HasSubstr("no way is known"));
}

/// A store of format 2 as far as it differed: its view of results held every case.
TEST(Migration, GivesAnOldStoreTheViewsOfToday) {
  const test::TemporaryFolder folder;
  {
    Store store = Store::open(folder.path(), OpenMode::kCreate);
    store.record_campaign(paper_campaign());
    store.connection().execute(
        "DROP VIEW results; DROP VIEW results_all; ALTER TABLE cases DROP COLUMN varied;"
        " CREATE VIEW results (label) AS SELECT label FROM cases;"
        " PRAGMA user_version = 2");
  }
  // Whoever only reads sees the present format, and leaves the file as it is.
  Store reader = Store::open(folder.path(), OpenMode::kReadOnly);
  EXPECT_EQ(answer(reader, "SELECT count(*) FROM results_all"), "7");
  EXPECT_EQ(answer(reader, "SELECT count(*) FROM documentation WHERE object = 'results_all'"),
            answer(reader, "SELECT count(*) FROM documentation WHERE object = 'results'"));
  Store writer = Store::open(folder.path(), OpenMode::kReadWrite);
  EXPECT_EQ(answer(writer, "SELECT count(*) FROM results"), "7");
  EXPECT_EQ(answer(writer, "PRAGMA user_version"), std::to_string(kSchemaVersion));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "results.db.format-2"));
}

TEST(ResultsView, ShowsTheCampaignAsItIsNow) {
  const test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  const Campaign before = paper_campaign();
  store.record_campaign(before);
  store.record_result(before.cases.back().definition.id, result_made_of(7), "");
  store.record_result(before.cases.front().definition.id, result_made_of(8), "");
  store.record_campaign(campaign_with(before.cases.front()));
  EXPECT_EQ(answer(store, "SELECT count(*) FROM results"), "1");
  EXPECT_EQ(answer(store, "SELECT count(*) FROM results_all"), "7");
  EXPECT_EQ(left_out(store.connection()), 1);
  store.forget(before.cases.back().definition.id);
  store.forget(before.cases.front().definition.id);  // part of the campaign: stays a case
  EXPECT_EQ(answer(store, "SELECT count(*) FROM cases"), "6");
  EXPECT_EQ(left_out(store.connection()), 0);
}

TEST(Store, KeepsWhatLeftTheSweepApart) {
  const test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  const Campaign all = paper_campaign();
  store.record_campaign(campaign_with(all.cases.front()));
  store.record_left_over({all.cases.back()});
  EXPECT_EQ(answer(store, "SELECT count(*) FROM cases WHERE in_campaign = 0"), "1");
  const std::string& id = all.cases.back().definition.id;
  AttemptEnd end = failed_at(3);
  end.wall_seconds = 3600;
  end.diagnostics = {{"divergence", 1e-3}};
  store.restore_attempt(id, 1, {"here", 2, ""}, end);
  const auto past = store.past_attempts(id);
  ASSERT_EQ(past.size(), 1U);
  EXPECT_EQ(past[0].end.diagnostics, end.diagnostics);
  EXPECT_EQ(past[0].end.step, 3);
  EXPECT_EQ(store.core_hours().at(id), 2.0);
}

/// A store as softwall 0.1.0 made it, with one attempt at work.
Connection store_of_format_1() {
  std::ostringstream sql;
  sql << std::ifstream(SOFTWALL_STORE_TESTS "/results_format_1.sql").rdbuf();
  Connection connection = Connection::open_in_memory();
  connection.execute(sql.str());
  connection.execute("PRAGMA application_id = " + std::to_string(kApplicationId) +
                     "; PRAGMA user_version = 1");
  connection.execute(
      "INSERT INTO cases (case_id, label, directory, is_precursor, flow, reynolds, grid, cells, end_time, "
      "ranks,"
      " physics, run, state_since, created) VALUES ('c', 'l', 'd', 0, 'f', 1, 'g', 1, 1, 1, '{}', '{}', 'n', "
      "'n');"
      "INSERT INTO attempts (case_id, attempt, intended, started, pid, host, ranks)"
      " VALUES ('c', 1, 'i', 's', 4711, 'node', 2)");
  return connection;
}

TEST(Migration, AStoreOfTheFirstFormatBecomesOneOfToday) {
  Connection old = store_of_format_1(), today = Connection::open_in_memory();
  create_schema(today);
  migrate(old, migrations(), kSchemaVersion);
  const char* columns =
      "SELECT s.name || '.' || c.name || ' ' || c.type FROM sqlite_schema s, pragma_table_xinfo(s.name) c"
      " WHERE s.type IN ('table', 'view') ORDER BY s.name, c.cid";
  EXPECT_THAT(column_of(old, columns), ElementsAreArray(column_of(today, columns)));
  EXPECT_THAT(column_of(old, "SELECT handle FROM attempts"),
              ElementsAreArray({R"({"host":"node","pid":4711})"}));
  EXPECT_EQ(old.integer("SELECT count(*) FROM timeline"), 2);
}

TEST(Migration, TimesOfResultsGetThePrecisionOfAllOthers) {
  Connection old = store_of_format_1();
  migrate(old, migrations(), 3);
  old.execute(
      "INSERT INTO quantities VALUES ('c', 'd', 1, NULL, 0, 1, 1, '', 1, '', '2026-01-31T23:59:59.123456Z'),"
      " ('c', 're_tau', 1, NULL, 0, 1, 1, '', 1, '', '2026-01-31T23:59:59.123Z')");
  migrate(old, migrations(), kSchemaVersion);
  EXPECT_EQ(old.integer("SELECT count(*) FROM quantities WHERE recorded = '2026-01-31T23:59:59.123Z'"), 2);
}

TEST(ResultsView, TellsWhatTheSweepVariesAndWhatItTook) {
  const test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  nlohmann::json document = elastic_campaign();
  document["sweep"] =
      nlohmann::json::parse(R"({"grid": {"G": [1], "seed": [1, 2], "formulation": ["reference_map"]}})");
  const Campaign campaign = campaign_of(document);
  store.record_campaign(campaign);
  EXPECT_EQ(answer(store, "SELECT group_concat(varied, ' ') FROM results WHERE G = 1"),
            R"({"seed":1} {"seed":2})");
  EXPECT_EQ(answer(store, "SELECT count(*) FROM results WHERE varied ->> 'seed' = 2"), "2")
      << "a precursor each";
  const std::string& id = campaign.cases.back().definition.id;
  for (const char* revision : {"first", "second"}) {
    AttemptEnd end = failed_at(100);
    end.wall_seconds = 1800;
    end.git_revision = revision;
    store.end_attempt(id, store.begin_attempt(id, {"here", 3, ""}), end);
  }
  EXPECT_EQ(
      answer(store, "SELECT core_hours || ' ' || solver_revision FROM results WHERE case_id = '" + id + "'"),
      "3.0 second");
}

TEST(Migration, AStepExistsFromEveryFormerFormat) {
  std::set<int> from;
  for (const Migration& step : migrations()) from.insert(step.from);
  for (int version = 1; version < kSchemaVersion; ++version) EXPECT_TRUE(from.contains(version)) << version;
}

}  // namespace
}  // namespace softwall::campaign::tests
