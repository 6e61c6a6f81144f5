#include "campaign/store/sqlite.hpp"

#include <sqlite3.h>

#include <array>

namespace softwall::campaign {

namespace {

constexpr int kBusyTimeoutMilliseconds = 10'000;

/// What the user can do about it, where SQLite's own words do not say.
std::string hint(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return "; the disk is full: nothing of this change was stored, free some space and repeat";
    case SQLITE_BUSY:
      return "; another program holds the store (waited " + std::to_string(kBusyTimeoutMilliseconds / 1000) +
             " s)";
    case SQLITE_NOTADB:
      return "; the file is no results store: nothing was changed";
    case SQLITE_CORRUPT:
      return "; the file is damaged: restore a backup, or move it away";
    default:
      return "";
  }
}

std::string message(const std::filesystem::path& file, const std::string& attempted, sqlite3* handle,
                    int code) {
  const char* words = handle != nullptr ? sqlite3_errmsg(handle) : sqlite3_errstr(code);
  return file.string() + ": " + attempted + ": " + words + " (SQLite code " + std::to_string(code) + ")" +
         hint(code);
}

/// A path inside an SQLite URI: '%', '?' and '#' have a meaning there.
std::string percent_encoded(const std::string& path) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : path) {
    if (c == '%' || c == '?' || c == '#') {
      const auto byte = static_cast<unsigned char>(c);
      encoded += {'%', kHex[byte >> 4], kHex[byte & 15]};
    } else {
      encoded += c;
    }
  }
  return encoded;
}

}  // namespace

void Connection::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

Connection Connection::open_uri(const std::string& name, const std::filesystem::path& file, int flags) {
  sqlite3* handle = nullptr;
  const int code =
      sqlite3_open_v2(name.c_str(), &handle, flags | SQLITE_OPEN_URI | SQLITE_OPEN_EXRESCODE, nullptr);
  Connection connection(file, handle);  // owns the handle even when opening failed
  if (code != SQLITE_OK) connection.fail("cannot open", code);
  sqlite3_busy_timeout(handle, kBusyTimeoutMilliseconds);
  // A database made by others cannot run code in us, and "text" is never silently a string literal.
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DQS_DDL, 0, nullptr);
  return connection;
}

Connection Connection::open(const std::filesystem::path& file, Access access, bool immutable) {
  const std::string name =
      "file:" + percent_encoded(std::filesystem::absolute(file).string()) + (immutable ? "?immutable=1" : "");
  return open_uri(name, file, access == Access::kReadOnly ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE);
}

Connection Connection::open_in_memory() {
  return open_uri(":memory:", "(in memory)", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
}

bool SqliteError::may_pass() const {
  const int code = primary_code();
  return code == SQLITE_BUSY || code == SQLITE_LOCKED || code == SQLITE_FULL || code == SQLITE_IOERR;
}

bool SqliteError::is_damage() const {
  return primary_code() == SQLITE_CORRUPT || primary_code() == SQLITE_NOTADB;
}

void Connection::wait_for_locks(std::function<bool()> wait_again) {
  auto kept = std::make_unique<std::function<bool()>>(std::move(wait_again));
  const auto ask = [](void* function, int /*tries*/) {
    return (*static_cast<std::function<bool()>*>(function))() ? 1 : 0;
  };
  sqlite3_busy_handler(handle_.get(), ask, kept.get());
  wait_again_ = std::move(kept);
}

void Connection::fail(const std::string& attempted, int code) const {
  throw SqliteError(message(file_, attempted, handle_.get(), code), code);
}

void Connection::execute(std::string_view sql) {
  const std::string text(sql);
  const int code = sqlite3_exec(handle_.get(), text.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail("cannot run " + text.substr(0, 60), code);
}

Statement Connection::prepare(std::string_view sql) { return {*this, sql}; }

std::int64_t Connection::integer(std::string_view sql) {
  Statement statement = prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

int Connection::changes() const { return sqlite3_changes(handle_.get()); }

StatementPool::~StatementPool() {
  for (const auto& [sql, statement] : idle_) sqlite3_finalize(statement);
}

sqlite3_stmt* StatementPool::take(std::string_view sql) {
  const auto found = idle_.find(sql);
  if (found == idle_.end()) return nullptr;
  sqlite3_stmt* const statement = found->second;
  idle_.erase(found);
  return statement;
}

void StatementPool::give_back(sqlite3_stmt* statement) {
  sqlite3_reset(statement);  // repeats the error of the last step, which step() has thrown already
  sqlite3_clear_bindings(statement);
  if (!idle_.try_emplace(sqlite3_sql(statement), statement).second) sqlite3_finalize(statement);
}

void Statement::Finalize::operator()(sqlite3_stmt* handle) const {
  pool != nullptr ? pool->give_back(handle) : static_cast<void>(sqlite3_finalize(handle));
}

Statement::Statement(const Connection& connection, std::string_view sql, StatementPool* pool)
    : file_(connection.file()), connection_(connection.handle()), handle_(nullptr, Finalize{pool}) {
  if (pool != nullptr) handle_.reset(pool->take(sql));
  if (handle_ != nullptr) return;
  sqlite3_stmt* handle = nullptr;
  const int code =
      sqlite3_prepare_v2(connection_, sql.data(), static_cast<int>(sql.size()), &handle, nullptr);
  handle_.reset(handle);
  check(code, "cannot understand SQL");
}

void Statement::check(int code, const char* attempted) const {
  if (code != SQLITE_OK) throw SqliteError(message(file_, attempted, connection_, code), code);
}

void Statement::bind(int index, std::nullptr_t) {
  check(sqlite3_bind_null(handle_.get(), index), "cannot bind");
}

void Statement::bind(int index, std::int64_t value) {
  check(sqlite3_bind_int64(handle_.get(), index, value), "cannot bind");
}

void Statement::bind(int index, double value) {
  check(sqlite3_bind_double(handle_.get(), index, value), "cannot bind");
}

void Statement::bind(int index, std::string_view text) {
  // A null pointer would bind NULL; an empty view may have one.
  const char* data = text.data() != nullptr ? text.data() : "";
  check(sqlite3_bind_text64(handle_.get(), index, data, text.size(), SQLITE_TRANSIENT, SQLITE_UTF8),
        "cannot bind");
}

bool Statement::step() {
  const int code = sqlite3_step(handle_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  throw SqliteError(message(file_, sqlite3_stmt_readonly(handle_.get()) != 0 ? "cannot read" : "cannot write",
                            connection_, code),
                    code);
}

void Statement::reset() {
  sqlite3_reset(handle_.get());  // repeats the error of the last step, which step() has thrown already
  sqlite3_clear_bindings(handle_.get());
}

int Statement::columns() const { return sqlite3_column_count(handle_.get()); }

std::string Statement::column_name(int column) const { return sqlite3_column_name(handle_.get(), column); }

int Statement::type(int column) const { return sqlite3_column_type(handle_.get(), column); }

bool Statement::is_null(int column) const { return type(column) == SQLITE_NULL; }

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_.get(), column); }

double Statement::real(int column) const { return sqlite3_column_double(handle_.get(), column); }

std::string Statement::text(int column) const {
  const auto* data = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
  if (data == nullptr) return "";
  return {data, static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

std::optional<std::int64_t> Statement::optional_integer(int column) const {
  if (is_null(column)) return std::nullopt;
  return integer(column);
}

std::optional<double> Statement::optional_real(int column) const {
  if (is_null(column)) return std::nullopt;
  return real(column);
}

Transaction::Transaction(Connection& connection)
    : connection_(connection), open_(sqlite3_get_autocommit(connection.handle()) != 0) {
  if (open_) connection_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!open_) return;
  // Some errors (disk full, I/O) have rolled back already; asking SQLite avoids a second error.
  if (sqlite3_get_autocommit(connection_.handle()) == 0) {
    sqlite3_exec(connection_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() {
  if (!open_) return;
  connection_.execute("COMMIT");
  open_ = false;
}

}  // namespace softwall::campaign
