#include "campaign/store/store_schema.hpp"

#include <sqlite3.h>

#include <array>
#include <string>
#include <vector>

#include "campaign/store/store_documentation.hpp"
#include "schemas/embedded.hpp"

namespace softwall::campaign {

namespace {

// PRAGMA takes no parameters; the numbers are ours.
void set_pragma(Connection& connection, const char* name, std::int64_t value) {
  connection.execute(std::string("PRAGMA ") + name + " = " + std::to_string(value));
}

void write_documentation(Connection& connection) {
  connection.execute("DELETE FROM documentation");
  for (const ColumnDocumentation& entry : documentation_in(schemas::kResultsSql)) {
    connection.run("INSERT INTO documentation (object, column_name, unit, meaning) VALUES (?, ?, ?, ?)",
                   entry.object, entry.column, entry.unit, entry.meaning);
  }
}

/// The views of results.sql stand behind its tables.
void renew_views(Connection& connection) {
  std::vector<std::string> old;
  {
    Statement names = connection.prepare("SELECT name FROM sqlite_schema WHERE type = 'view'");
    while (names.step()) old.push_back(names.text(0));
  }
  for (const std::string& name : old) connection.execute("DROP VIEW \"" + name + "\"");
  connection.execute(schemas::kResultsSql.substr(schemas::kResultsSql.find("\nCREATE VIEW ")));
}

const Migration& step_from(int version, std::span<const Migration> steps, const Connection& connection) {
  for (const Migration& step : steps) {
    if (step.from == version) return step;
  }
  throw SqliteError(connection.file().string() + ": no way is known from store format " +
                        std::to_string(version) + " to the next",
                    0);
}

}  // namespace

std::span<const Migration> migrations() {
  static constexpr std::array<Migration, 4> kSteps = {{
      {1, schemas::kFrom1Sql},
      {2, ""},  // views only: results shows the present campaign, results_all everything
      {3, schemas::kFrom3Sql},
      {4, ""},  // views only: started_from
  }};
  return kSteps;
}

void create_schema(Connection& connection) {
  Transaction transaction(connection);
  connection.execute(schemas::kResultsSql);
  write_documentation(connection);
  set_pragma(connection, "application_id", kApplicationId);
  set_pragma(connection, "user_version", kSchemaVersion);
  transaction.commit();
}

int schema_version(Connection& connection, int known) {
  const std::string file = connection.file().string();
  if (connection.integer("PRAGMA application_id") != kApplicationId) {
    throw SqliteError(file + ": an SQLite database, but no results store of softwall: nothing was changed",
                      0);
  }
  const auto version = connection.integer("PRAGMA user_version");
  if (version > known) {
    throw SqliteError(file + ": store format " + std::to_string(version) +
                          " was made by a newer softwall; this one knows formats up to " +
                          std::to_string(known) + ": nothing was changed, use the newer program",
                      SQLITE_SCHEMA);
  }
  if (version < 1) {
    throw SqliteError(
        file + ": store format " + std::to_string(version) + " does not exist: the file is damaged", 0);
  }
  return static_cast<int>(version);
}

bool is_of_newer_format(const SqliteError& error) { return error.code() == SQLITE_SCHEMA; }

void migrate(Connection& connection, std::span<const Migration> steps, int target) {
  Transaction transaction(connection);  // first, so that two programs cannot both start from the old format
  const int found = schema_version(connection, target);
  for (int version = found; version < target; ++version) {
    connection.execute(step_from(version, steps, connection).sql);
  }
  if (found < target) {
    renew_views(connection);
    write_documentation(connection);
    set_pragma(connection, "user_version", target);
  }
  transaction.commit();
}

}  // namespace softwall::campaign
