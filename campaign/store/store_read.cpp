#include "campaign/core/words.hpp"
#include "campaign/store/store.hpp"

namespace softwall::campaign {

namespace {

/// Attempts that count as failures without progress: ended, by no fault from outside, later than the case was
/// forgiven and later than the last attempt that got further than every one before it.
constexpr std::string_view kWithoutProgress = R"sql(
WITH history AS (
  SELECT attempt, ended, outcome, coalesce(step, 0) AS step,
    max(coalesce(step, 0)) OVER (ORDER BY attempt ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING) AS best_before
  FROM attempts WHERE case_id = ?1)
SELECT count(*) FROM history
WHERE ended IS NOT NULL AND outcome NOT IN ('finished', 'interrupted', 'not started', 'lost')
  AND attempt > (SELECT coalesce(max(attempt), 0) FROM history WHERE step > coalesce(best_before, 0))
  AND attempt > (SELECT forgiven FROM cases WHERE case_id = ?1)
)sql";

constexpr std::string_view kCaseColumns =
    "SELECT case_id, label, directory, is_precursor, state, state_reason, stale_reason FROM cases ";
constexpr std::string_view kAttemptColumns =
    "SELECT case_id, attempt, intended, started, ended, pid, host, ranks, outcome, reason, exit_code, step,"
    " time, wall_seconds, ns_per_cell_step FROM attempts ";

std::optional<int> optional_int(const Statement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  return static_cast<int>(row.integer(column));
}

AttemptRecord attempt_in(const Statement& row) {
  AttemptRecord record;
  record.case_id = row.text(0);
  record.attempt = static_cast<int>(row.integer(1));
  record.intended = row.text(2);
  record.started = row.text(3);
  record.ended = row.text(4);
  record.pid = row.optional_integer(5);
  record.host = row.text(6);
  record.ranks = static_cast<int>(row.integer(7));
  record.outcome = row.text(8);
  record.reason = row.text(9);
  record.exit_code = optional_int(row, 10);
  record.step = row.optional_integer(11);
  record.time = row.optional_real(12);
  record.wall_seconds = row.optional_real(13);
  record.ns_per_cell_step = row.optional_real(14);
  return record;
}

std::vector<AttemptRecord> all_attempts(Statement rows) {
  std::vector<AttemptRecord> records;
  while (rows.step()) records.push_back(attempt_in(rows));
  return records;
}

CaseRecord case_in(const Statement& row, const Store& store) {
  CaseRecord record;
  record.case_id = row.text(0);
  record.label = row.text(1);
  record.directory = row.text(2);
  record.is_precursor = row.integer(3) != 0;
  record.state = state_of(row.text(4)).value();  // the table's CHECK allows no other word
  record.state_reason = row.text(5);
  record.stale_reason = row.text(6);
  record.attempts = store.attempts(record.case_id);
  record.attempts_without_progress = store.attempts_without_progress(record.case_id);
  return record;
}

}  // namespace

std::vector<CaseRecord> Store::cases() const {
  Statement rows = connection_.query(std::string(kCaseColumns) + "ORDER BY is_precursor DESC, rowid");
  std::vector<CaseRecord> records;
  while (rows.step()) records.push_back(case_in(rows, *this));
  return records;
}

std::optional<CaseRecord> Store::find_case(const std::string& case_id) const {
  Statement rows = connection_.query(std::string(kCaseColumns) + "WHERE case_id = ?", case_id);
  if (!rows.step()) return std::nullopt;
  return case_in(rows, *this);
}

int Store::attempts(const std::string& case_id) const {
  Statement row =
      connection_.query("SELECT coalesce(max(attempt), 0) FROM attempts WHERE case_id = ?", case_id);
  return row.step() ? static_cast<int>(row.integer(0)) : 0;
}

int Store::attempts_without_progress(const std::string& case_id) const {
  Statement row = connection_.query(kWithoutProgress, case_id);
  return row.step() ? static_cast<int>(row.integer(0)) : 0;
}

std::vector<AttemptRecord> Store::attempt_history(const std::string& case_id) const {
  return all_attempts(
      connection_.query(std::string(kAttemptColumns) + "WHERE case_id = ? ORDER BY attempt", case_id));
}

std::vector<AttemptRecord> Store::open_attempts() const {
  return all_attempts(
      connection_.query(std::string(kAttemptColumns) + "WHERE ended IS NULL ORDER BY case_id, attempt"));
}

}  // namespace softwall::campaign
