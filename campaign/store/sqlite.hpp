#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

struct sqlite3;
struct sqlite3_stmt;

/// Owners of SQLite's handles. Every call is checked; a failure throws SqliteError.
namespace softwall::campaign {

/// what(): file, what was attempted, SQLite's words and its code.
class SqliteError : public std::runtime_error {
 public:
  SqliteError(const std::string& message, int code) : std::runtime_error(message), code_(code) {}
  /// Extended result code; its low byte is the primary one (SQLITE_FULL, ...). 0: refused by softwall itself.
  [[nodiscard]] int code() const { return code_; }
  [[nodiscard]] int primary_code() const { return code_ & 0xff; }
  /// True for trouble around a sound store that may pass: a lock, a full disk, an I/O error.
  [[nodiscard]] bool may_pass() const;
  /// True for a file that is no sound store any more.
  [[nodiscard]] bool is_damage() const;

 private:
  int code_;
};

class Statement;

enum class Access { kReadOnly, kReadWrite };

/// Prepared statements that nobody uses at the moment, by their SQL: a store asks the same few questions for
/// every case, and understanding one takes SQLite longer than answering it.
class StatementPool {
 public:
  StatementPool() = default;
  ~StatementPool();
  StatementPool(const StatementPool&) = delete;
  StatementPool& operator=(const StatementPool&) = delete;
  /// Null when there is none.
  [[nodiscard]] sqlite3_stmt* take(std::string_view sql);
  /// Takes ownership.
  void give_back(sqlite3_stmt* statement);

 private:
  std::map<std::string, sqlite3_stmt*, std::less<>> idle_;
};

class Connection {
 public:
  /// Never creates a file. immutable: the file cannot change while open (read-only media), so no locks are
  /// taken and a -wal file beside it is not read.
  [[nodiscard]] static Connection open(const std::filesystem::path& file, Access access,
                                       bool immutable = false);
  [[nodiscard]] static Connection open_in_memory();

  /// Asks `wait_again` each time another program's lock is in the way; true: try again, false: give up with
  /// SQLITE_BUSY. It waits itself. Without it, ten seconds.
  void wait_for_locks(std::function<bool()> wait_again);

  /// One or several statements without results or parameters.
  void execute(std::string_view sql);
  [[nodiscard]] Statement prepare(std::string_view sql);
  /// Prepares, binds in order and runs to the end.
  template <class... Values>
  void run(std::string_view sql, const Values&... values);
  /// Prepares and binds in order; step() fetches the rows.
  template <class... Values>
  [[nodiscard]] Statement query(std::string_view sql, const Values&... values);
  /// First column of the first row as an integer; 0 when there is no row.
  [[nodiscard]] std::int64_t integer(std::string_view sql);

  /// Rows touched by the last INSERT, UPDATE or DELETE.
  [[nodiscard]] int changes() const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] sqlite3* handle() const { return handle_.get(); }
  [[noreturn]] void fail(const std::string& attempted, int code) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  Connection(std::filesystem::path file, sqlite3* handle) : file_(std::move(file)), handle_(handle) {}
  static Connection open_uri(const std::string& name, const std::filesystem::path& file, int flags);

  std::filesystem::path file_;
  std::unique_ptr<std::function<bool()>> wait_again_;  ///< where SQLite knows it to be; outlives the handle
  std::unique_ptr<sqlite3, Close> handle_;
  std::unique_ptr<StatementPool> pool_ =
      std::make_unique<StatementPool>();  ///< empty before the handle closes
};

/// A prepared statement; must not outlive its Connection. Parameters count from 1, columns from 0.
class Statement {
 public:
  /// pool: where it is taken from and goes back to; none: it is prepared, and gone with this object.
  Statement(const Connection& connection, std::string_view sql, StatementPool* pool = nullptr);

  void bind(int index, std::nullptr_t);
  void bind(int index, bool value) { bind(index, static_cast<std::int64_t>(value)); }
  void bind(int index, int value) { bind(index, static_cast<std::int64_t>(value)); }
  void bind(int index, std::int64_t value);
  void bind(int index, double value);  ///< NaN becomes NULL
  void bind(int index, std::string_view text);
  void bind(int index, const std::string& text) { bind(index, std::string_view(text)); }
  void bind(int index, const char* text) { bind(index, std::string_view(text)); }
  template <class T>
  void bind(int index, const std::optional<T>& value) {
    if (value)
      bind(index, *value);
    else
      bind(index, nullptr);
  }
  template <class... Values>
  void bind_all(const Values&... values) {
    int index = 0;
    (bind(++index, values), ...);
  }

  /// True: a row is there to be read. False: done.
  bool step();
  void reset();

  [[nodiscard]] int columns() const;
  [[nodiscard]] std::string column_name(int column) const;
  [[nodiscard]] int type(
      int column) const;  ///< SQLITE_INTEGER, SQLITE_FLOAT, SQLITE_TEXT, SQLITE_BLOB, SQLITE_NULL
  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] std::string text(int column) const;  ///< empty for NULL; may hold NUL bytes
  [[nodiscard]] std::optional<std::int64_t> optional_integer(int column) const;
  [[nodiscard]] std::optional<double> optional_real(int column) const;
  [[nodiscard]] sqlite3_stmt* handle() const { return handle_.get(); }

 private:
  struct Finalize {
    StatementPool* pool = nullptr;
    void operator()(sqlite3_stmt* handle) const;
  };
  void check(int code, const char* attempted) const;

  const std::filesystem::path file_;
  sqlite3* connection_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

/// BEGIN IMMEDIATE: takes the write lock at once. Rolled back by the destructor unless committed. Inside
/// another one it is a part of that one, which alone decides: many small writes become durable together, at
/// the cost of one.
class Transaction {
 public:
  explicit Transaction(Connection& connection);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Connection& connection_;
  bool open_;  ///< false: a part of another one, or committed
};

template <class... Values>
Statement Connection::query(std::string_view sql, const Values&... values) {
  Statement statement(*this, sql, pool_.get());
  statement.bind_all(values...);
  return statement;
}

template <class... Values>
void Connection::run(std::string_view sql, const Values&... values) {
  Statement statement = query(sql, values...);
  while (statement.step()) {
  }
}

}  // namespace softwall::campaign
