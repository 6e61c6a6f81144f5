#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "campaign/core/words.hpp"
#include "campaign/store/store.hpp"

namespace softwall::campaign {

namespace {

constexpr std::string_view kAllCases =
    "SELECT case_id, label, directory, is_precursor, state, state_reason, stale_reason, state_since, forgiven"
    " FROM cases";

CaseRecord case_in(const Statement& row) {
  CaseRecord record;
  record.case_id = row.text(0);
  record.label = row.text(1);
  record.directory = row.text(2);
  record.is_precursor = row.integer(3) != 0;
  record.state = state_of(row.text(4)).value();  // the table's CHECK allows no other word
  record.state_reason = row.text(5);
  record.stale_reason = row.text(6);
  record.state_since = row.text(7);
  return record;
}

constexpr std::string_view kAttempts =
    "SELECT case_id, attempt, ended IS NOT NULL, outcome, step, time, wall_seconds, attempt_steps,"
    " ranks FROM attempts";

bool is_fault_of_the_case(const std::string& outcome) {
  constexpr std::array<std::string_view, 5> kOthersFault = {"finished", "interrupted", "not started", "lost",
                                                            "node failure"};
  return std::ranges::find(kOthersFault, outcome) == kOthersFault.end();
}

/// What the attempts of one case, taken in their order, say about it.
class AttemptTally {
 public:
  AttemptTally(CaseRecord& record, int forgiven) : record_(record), forgiven_(forgiven) {}

  void add(const Statement& row) {
    const auto attempt = static_cast<int>(row.integer(1));
    const bool ended = row.integer(2) != 0;
    const std::string outcome = row.text(3);
    const std::int64_t step = row.integer(4);
    record_.attempts = attempt;
    record_.seconds_per_step = row.integer(7) != 0 ? row.real(6) / static_cast<double>(row.integer(7)) : 0.0;
    record_.measured_ranks = static_cast<int>(row.integer(8));
    // Whoever ends in order leaves a checkpoint of its last step: a store made anew knows no older ones.
    if (step > 0 && (outcome == "finished" || outcome == "interrupted")) record_.had_checkpoints = true;
    if (outcome == "finished") {
      record_.reached_time = std::max(record_.reached_time, row.real(5));
      record_.reached_step = std::max(record_.reached_step, step);
    }
    if (step > furthest_) {
      furthest_ = step;
      record_.attempts_without_progress = 0;
    } else if (ended && attempt > forgiven_ && is_fault_of_the_case(outcome)) {
      ++record_.attempts_without_progress;
    }
  }

 private:
  CaseRecord& record_;
  int forgiven_;  ///< attempts up to this one no longer count as failures
  std::int64_t furthest_ = 0;
};

/// Throws SqliteError, of damage, where the case is missing of which the store has more.
CaseRecord& record_of(const std::string& case_id, std::unordered_map<std::string, CaseRecord>& records,
                      const std::filesystem::path& store) {
  const auto record = records.find(case_id);
  if (record != records.end()) return record->second;
  throw SqliteError(
      store.string() + ": damaged: it knows what became of case " + case_id + ", and not the case",
      SQLITE_CORRUPT);
}

constexpr std::string_view kCheckpoints = "SELECT case_id, step, seen FROM checkpoints";

void add_checkpoint(const Statement& row, CaseRecord& record) {
  record.had_checkpoints = record.had_checkpoints || row.integer(1) > 0;
  record.checkpoints_seen = std::max(record.checkpoints_seen, row.text(2));
}

/// Answers about cases, their attempts and their checkpoints: of all cases or of one.
struct CaseRows {
  Statement cases, attempts, checkpoints;
};

/// One pass over each: the answer to one question about all of them takes SQLite several times as long.
std::unordered_map<std::string, CaseRecord> records_in(const std::filesystem::path& store, CaseRows rows) {
  auto& [cases, attempts, checkpoints] = rows;
  std::unordered_map<std::string, CaseRecord> records;
  std::unordered_map<std::string, int> forgiven;
  while (cases.step()) {
    CaseRecord record = case_in(cases);
    if (cases.integer(8) > 0) forgiven[record.case_id] = static_cast<int>(cases.integer(8));
    records.emplace(record.case_id, std::move(record));
  }
  std::optional<AttemptTally> tally;
  std::string tallied;
  while (attempts.step()) {
    if (std::string id = attempts.text(0); !tally || id != tallied) {
      const auto pardon = forgiven.find(id);
      tally.emplace(record_of(id, records, store), pardon == forgiven.end() ? 0 : pardon->second);
      tallied = std::move(id);
    }
    tally->add(attempts);
  }
  while (checkpoints.step()) add_checkpoint(checkpoints, record_of(checkpoints.text(0), records, store));
  return records;
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
  static const std::string kCase = std::string(kAllCases) + " WHERE case_id = ?";
  static const std::string kAttemptsOfCase = std::string(kAttempts) + " WHERE case_id = ? ORDER BY attempt";
  static const std::string kCheckpointsOfCase = std::string(kCheckpoints) + " WHERE case_id = ?";
  auto found =
      records_in(connection_.file(), {.cases = connection_.query(kCase, case_id),
                                      .attempts = connection_.query(kAttemptsOfCase, case_id),
                                      .checkpoints = connection_.query(kCheckpointsOfCase, case_id)});
  if (found.empty()) return std::nullopt;
  return std::move(found.begin()->second);
}

std::unordered_map<std::string, CaseRecord> Store::all_cases() const {
  static const std::string kAllAttempts = std::string(kAttempts) + " ORDER BY case_id, attempt";
  return records_in(connection_.file(), {.cases = connection_.query(kAllCases),
                                         .attempts = connection_.query(kAllAttempts),
                                         .checkpoints = connection_.query(kCheckpoints)});
}

int Store::attempts(const std::string& case_id) const {
  Statement row =
      connection_.query("SELECT coalesce(max(attempt), 0) FROM attempts WHERE case_id = ?", case_id);
  return row.step() ? static_cast<int>(row.integer(0)) : 0;
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

std::vector<OpenAttempt> Store::open_attempts(const std::string& case_id) const {
  Statement rows = connection_.query(
      "SELECT attempt FROM attempts WHERE case_id = ? AND ended IS NULL ORDER BY attempt", case_id);
  std::vector<OpenAttempt> found;
  while (rows.step()) found.push_back({case_id, static_cast<int>(rows.integer(0))});
  return found;
}

}  // namespace softwall::campaign
