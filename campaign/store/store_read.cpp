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

constexpr std::string_view kCaseQuery =
    "SELECT case_id, label, directory, is_precursor, state, state_reason, stale_reason FROM cases"
    " WHERE case_id = ?";
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

std::optional<CaseRecord> Store::find_case(const std::string& case_id) const {
  Statement rows = connection_.query(kCaseQuery, case_id);
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

std::vector<OpenAttempt> Store::open_attempts() const {
  Statement rows = connection_.query(
      "SELECT case_id, attempt FROM attempts WHERE ended IS NULL ORDER BY case_id, attempt");
  std::vector<OpenAttempt> found;
  while (rows.step()) found.push_back({rows.text(0), static_cast<int>(rows.integer(1))});
  return found;
}

}  // namespace softwall::campaign
