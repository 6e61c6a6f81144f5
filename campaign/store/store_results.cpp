#include "campaign/store/store.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {

namespace {

using analysis::DerivedQuantities;

/// Details of the average and of the log-law fit, stored beside the measured quantities but without interval.
struct Detail {
  std::string_view name;
  double DerivedQuantities::*member;
};
constexpr std::array<Detail, 7> kDetails = {{
    {"log_range_low_plus", &DerivedQuantities::log_range_low_plus},
    {"log_range_high_plus", &DerivedQuantities::log_range_high_plus},
    {"log_residual", &DerivedQuantities::log_residual},
    {"log_intercept", &DerivedQuantities::log_intercept},
    {"stress_balance_residual", &DerivedQuantities::stress_balance_residual},
    {"sampled_time", &DerivedQuantities::sampled_time},
    {"window_asked", &DerivedQuantities::window_asked},
}};

/// Every result has the quantity "batches", and those of one result have the same origin. Results of earlier
/// versions do not say which window was asked for.
std::string origins_query() {
  return "SELECT q.case_id, q.analysis_version, q.window_start, q.window_end, q.recorded, w.value"
         " FROM quantities q LEFT JOIN quantities w ON w.case_id = q.case_id AND w.quantity = 'window_asked'"
         " WHERE q.quantity = 'batches'";
}

ResultOrigin origin_in(const Statement& row) {
  return {static_cast<int>(row.integer(1)), row.real(2), row.real(3), row.optional_real(5), row.text(4)};
}

}  // namespace

void Store::record_result(const std::string& case_id, const DerivedQuantities& derived,
                          const std::string& git_revision) {
  const std::string now = utc_now();
  const auto write = [&](std::string_view quantity, double value, std::optional<double> ci95) {
    connection_.run(
        "INSERT INTO quantities (case_id, quantity, value, ci95, window_start, window_end, blocks, note,"
        " analysis_version, git_revision, recorded) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        case_id, quantity, value, ci95, derived.window_start, derived.window_end, derived.blocks,
        derived.note, analysis::kAnalysisVersion, git_revision, now);
  };
  Transaction transaction(connection_);
  connection_.run("DELETE FROM quantities WHERE case_id = ?", case_id);
  for (const auto& [name, member] : analysis::kMeasuredMembers) {
    write(name, (derived.*member).value, (derived.*member).ci95);
  }
  for (const auto& [name, member] : kDetails) write(name, derived.*member, std::nullopt);
  write("batches", derived.batches, std::nullopt);
  transaction.commit();
}

void Store::remove_result(const std::string& case_id) {
  connection_.run("DELETE FROM quantities WHERE case_id = ?", case_id);
}

std::optional<ResultOrigin> Store::result_origin(const std::string& case_id) const {
  Statement found = connection_.query(origins_query() + " AND q.case_id = ?", case_id);
  if (!found.step()) return std::nullopt;
  return origin_in(found);
}

std::unordered_map<std::string, ResultOrigin> Store::result_origins() const {
  Statement rows = connection_.prepare(origins_query());
  std::unordered_map<std::string, ResultOrigin> all;
  while (rows.step()) all[rows.text(0)] = origin_in(rows);
  return all;
}

}  // namespace softwall::campaign
