#include "campaign/store/query.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "solver/case/spelling.hpp"

namespace softwall::campaign {

namespace {

[[noreturn]] void refuse(const Connection& connection, const std::string& why) {
  throw SqliteError(connection.file().string() + ": " + why, 0);
}

/// The pragmas that only look. They stay harmless with a value, which is the name of a table.
bool is_looking_pragma(const char* name) {
  constexpr std::array<const char*, 8> kLooking = {"table_list",       "table_info",     "table_xinfo",
                                                   "index_list",       "index_info",     "index_xinfo",
                                                   "foreign_key_list", "compile_options"};
  return std::any_of(kLooking.begin(), kLooking.end(),
                     [name](const char* known) { return sqlite3_stricmp(name, known) == 0; });
}

/// Called by SQLite for everything a statement wants to do, before it does it. The connection is read-only
/// anyhow; this also keeps it from opening other files and from changing its own settings.
int allow_reading(void* /*data*/, int action, const char* first, const char* second, const char* /*database*/,
                  const char* /*trigger*/) {
  switch (action) {
    case SQLITE_SELECT:
    case SQLITE_READ:
    case SQLITE_RECURSIVE:
      return SQLITE_OK;
    case SQLITE_FUNCTION:
      return sqlite3_stricmp(second, "load_extension") == 0 ? SQLITE_DENY : SQLITE_OK;
    case SQLITE_UPDATE:  // how SQLite asks when it introduces pragma_table_info() or json_each(); writes
                         // nothing
      return sqlite3_stricmp(first, "sqlite_master") == 0 ? SQLITE_OK : SQLITE_DENY;
    case SQLITE_PRAGMA:
      return is_looking_pragma(first) ? SQLITE_OK : SQLITE_DENY;
    default:
      return SQLITE_DENY;
  }
}

Statement prepare_for_reading(Connection& connection, std::string_view sql) {
  try {
    return connection.prepare(sql);
  } catch (const SqliteError& error) {
    if (error.primary_code() != SQLITE_AUTH) throw;
    refuse(connection, "a query may only read; changes go through the other softwall commands");
  }
}

/// What SQLite left unread must hold no second statement.
void check_single(Connection& connection, const Statement& statement, std::string_view sql) {
  if (statement.handle() == nullptr) refuse(connection, "the query is empty");
  const std::string_view rest =
      sql.substr(std::min(sql.size(), std::strlen(sqlite3_sql(statement.handle()))));
  if (rest.find_first_not_of("; \t\r\n") == std::string_view::npos) return;
  bool more = true;
  try {
    more = connection.prepare(rest).handle() != nullptr;  // comments alone make no statement
  } catch (const SqliteError&) {
  }
  if (more) refuse(connection, "one SQL statement at a time");
}

Cell cell_of(const Statement& row, int column) {
  switch (row.type(column)) {
    case SQLITE_NULL:
      return std::monostate{};
    case SQLITE_INTEGER:
      return row.integer(column);
    case SQLITE_FLOAT:
      return row.real(column);
    default:
      return row.text(column);
  }
}

ResultTable fetch(Statement& statement) {
  ResultTable table;
  for (int i = 0; i < statement.columns(); ++i) table.columns.push_back(statement.column_name(i));
  while (statement.step()) {
    table.rows.emplace_back();
    for (int i = 0; i < statement.columns(); ++i) table.rows.back().push_back(cell_of(statement, i));
  }
  return table;
}

/// Columns, or tables and views, those of `results` first: of words equally near, the first is suggested.
std::vector<std::string> names_in(Connection& store, bool columns) {
  Statement rows =
      store.prepare(columns ? "SELECT DISTINCT column_name FROM documentation WHERE column_name <> ''"
                              " ORDER BY object <> 'results_all'"
                            : "SELECT name FROM sqlite_schema WHERE type IN ('table', 'view')");
  std::vector<std::string> names;
  while (rows.step()) names.push_back(rows.text(0));
  return names;
}

}  // namespace

ResultTable run_query(Connection& connection, std::string_view sql) {
  if (sql.find('\0') != std::string_view::npos) refuse(connection, "the query holds a NUL character");
  sqlite3_set_authorizer(connection.handle(), allow_reading, nullptr);
  Statement statement = prepare_for_reading(connection, sql);
  check_single(connection, statement, sql);
  if (sqlite3_stmt_readonly(statement.handle()) == 0) refuse(connection, "a query may only read");
  return fetch(statement);
}

std::string advice_for_query(Connection& store, const std::string& refusal) {
  constexpr std::string_view kColumn = "no such column: ", kTable = "no such table: ";
  const bool column = refusal.find(kColumn) != std::string::npos;
  const std::string_view marker = column ? kColumn : kTable;
  const auto found = refusal.find(marker);
  if (found == std::string::npos) return "one SQL statement that reads";
  std::string name = refusal.substr(found + marker.size());
  name = name.substr(0, name.find_first_of(" ;,\n"));  // SQLite's code stands behind it
  name = name.substr(name.rfind('.') + 1);             // "results.re_tua"
  const auto near = suggestion(name, names_in(store, column));
  if (near) return "did you mean " + *near + "?";
  return column ? "SELECT object, column_name, unit, meaning FROM documentation lists all columns"
                : "SELECT DISTINCT object FROM documentation lists all tables";
}

std::int64_t left_out(Connection& store) {
  return store.integer("SELECT count(*) FROM results_all WHERE in_campaign = 0 AND window_start IS NOT NULL");
}

ResultTable export_results(Connection& store) { return run_query(store, "SELECT * FROM results"); }

}  // namespace softwall::campaign
