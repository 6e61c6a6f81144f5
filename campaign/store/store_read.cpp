#include "campaign/core/words.hpp"
#include "campaign/store/store.hpp"

namespace softwall::campaign {

namespace {

/// All of them, or the one that ?1 names. Attempts that count as failures without progress: ended, by no
/// fault from outside, later than the case was forgiven and later than the last attempt that got further than
/// every one before it. The parts are joined, never looked up case by case: ten thousand cases take one pass.
std::string records_query(bool one) {
  const std::string attempts_of = one ? "attempts WHERE case_id = ?1" : "attempts";
  return "WITH history AS ("
         "  SELECT case_id, attempt, ended, outcome, coalesce(step, 0) AS step, max(coalesce(step, 0)) OVER"
         "    (PARTITION BY case_id ORDER BY attempt ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING)"
         "    AS best_before FROM " +
         attempts_of +
         "),"
         " progress AS (SELECT case_id, max(attempt) AS attempt FROM history"
         "  WHERE step > coalesce(best_before, 0) GROUP BY case_id),"
         " failures AS (SELECT h.case_id, count(*) AS number FROM history h JOIN cases c USING (case_id)"
         "  LEFT JOIN progress p USING (case_id) WHERE h.ended IS NOT NULL"
         "  AND h.outcome NOT IN ('finished', 'interrupted', 'not started', 'lost')"
         "  AND h.attempt > coalesce(p.attempt, 0) AND h.attempt > c.forgiven GROUP BY h.case_id),"
         " totals AS (SELECT case_id, max(attempt) AS newest, wall_seconds / nullif(attempt_steps, 0) AS pace"
         "  FROM " +
         attempts_of + (one ? "" : " GROUP BY case_id") +
         "),"
         " ends AS (SELECT case_id, max(time) AS time, max(step) AS step FROM " +
         attempts_of + (one ? " AND" : " WHERE") + " outcome = 'finished'" +
         (one ? "" : " GROUP BY case_id") +
         ")"
         " SELECT c.case_id, label, directory, is_precursor, state, state_reason, stale_reason,"
         " coalesce(t.newest, 0), coalesce(f.number, 0), coalesce(e.time, 0), coalesce(e.step, 0),"
         " coalesce(t.pace, 0), state_since"
         " FROM cases c LEFT JOIN totals t USING (case_id) LEFT JOIN failures f USING (case_id)"
         " LEFT JOIN ends e USING (case_id)" +
         (one ? " WHERE c.case_id = ?1" : "");
}

CaseRecord case_in(const Statement& row) {
  CaseRecord record;
  record.case_id = row.text(0);
  record.label = row.text(1);
  record.directory = row.text(2);
  record.is_precursor = row.integer(3) != 0;
  record.state = state_of(row.text(4)).value();  // the table's CHECK allows no other word
  record.state_reason = row.text(5);
  record.stale_reason = row.text(6);
  record.attempts = static_cast<int>(row.integer(7));
  record.attempts_without_progress = static_cast<int>(row.integer(8));
  record.reached_time = row.real(9);
  record.reached_step = row.integer(10);
  record.seconds_per_step = row.real(11);
  record.state_since = row.text(12);
  return record;
}

constexpr std::string_view kPastAttempts =
    "SELECT attempt, host, ranks, coalesce(resumed_from, ''), outcome, coalesce(reason, ''), exit_code, "
    "step, time,"
    " attempt_steps, wall_seconds, ns_per_cell_step, coalesce(started, intended), ended, version, "
    "git_revision,"
    " build_type, compiler FROM attempts WHERE case_id = ? AND ended IS NOT NULL ORDER BY attempt";

PastAttempt past_attempt_in(const Statement& row) {
  PastAttempt past;
  past.attempt = static_cast<int>(row.integer(0));
  past.start = {row.text(1), static_cast<int>(row.integer(2)), row.text(3)};
  AttemptEnd& end = past.end;
  end.outcome = outcome_of(row.text(4)).value_or(AttemptOutcome::kFailed);
  end.reason = row.text(5);
  if (!row.is_null(6)) end.exit_code = static_cast<int>(row.integer(6));
  end.step = row.optional_integer(7);
  end.time = row.optional_real(8);
  end.attempt_steps = row.optional_integer(9);
  end.wall_seconds = row.optional_real(10);
  end.ns_per_cell_step = row.optional_real(11);
  end.started = row.text(12);
  end.ended = row.text(13);
  end.version = row.text(14);
  end.git_revision = row.text(15);
  end.build_type = row.text(16);
  end.compiler = row.text(17);
  return past;
}

}  // namespace

std::optional<CaseRecord> Store::find_case(const std::string& case_id) const {
  Statement rows = connection_.query(records_query(true), case_id);
  if (!rows.step()) return std::nullopt;
  return case_in(rows);
}

std::unordered_map<std::string, CaseRecord> Store::all_cases() const {
  std::unordered_map<std::string, CaseRecord> all;
  Statement rows = connection_.prepare(records_query(false));
  while (rows.step()) {
    CaseRecord record = case_in(rows);
    all.emplace(record.case_id, std::move(record));
  }
  return all;
}

int Store::attempts(const std::string& case_id) const {
  Statement row =
      connection_.query("SELECT coalesce(max(attempt), 0) FROM attempts WHERE case_id = ?", case_id);
  return row.step() ? static_cast<int>(row.integer(0)) : 0;
}

int Store::attempts_without_progress(const std::string& case_id) const {
  const auto record = find_case(case_id);
  return record ? record->attempts_without_progress : 0;
}

std::vector<PastAttempt> Store::past_attempts(const std::string& case_id) const {
  Statement rows = connection_.query(kPastAttempts, case_id);
  std::vector<PastAttempt> attempts;
  while (rows.step()) attempts.push_back(past_attempt_in(rows));
  Statement diagnostics = connection_.query(
      "SELECT attempt, name, value FROM diagnostics WHERE case_id = ? AND value IS NOT NULL", case_id);
  while (diagnostics.step()) {
    for (PastAttempt& past : attempts) {
      if (past.attempt == diagnostics.integer(0))
        past.end.diagnostics[diagnostics.text(1)] = diagnostics.real(2);
    }
  }
  return attempts;
}

std::map<std::string, double> Store::core_hours() const {
  Statement rows =
      connection_.query("SELECT case_id, sum(wall_seconds * ranks) / 3600.0 FROM attempts GROUP BY case_id");
  std::map<std::string, double> hours;
  while (rows.step()) hours[rows.text(0)] = rows.real(1);
  return hours;
}

std::vector<OpenAttempt> Store::open_attempts() const {
  Statement rows = connection_.query(
      "SELECT case_id, attempt FROM attempts WHERE ended IS NULL ORDER BY case_id, attempt");
  std::vector<OpenAttempt> found;
  while (rows.step()) found.push_back({rows.text(0), static_cast<int>(rows.integer(1))});
  return found;
}

std::vector<OpenAttempt> Store::open_attempts(const std::string& case_id) const {
  Statement rows = connection_.query(
      "SELECT attempt FROM attempts WHERE case_id = ? AND ended IS NULL ORDER BY attempt", case_id);
  std::vector<OpenAttempt> found;
  while (rows.step()) found.push_back({case_id, static_cast<int>(rows.integer(0))});
  return found;
}

}  // namespace softwall::campaign
