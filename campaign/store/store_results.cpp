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

/// Every result has the quantity "batches", and the rows of one result have the same origin. Results of
/// earlier versions do not say which window was asked for.
constexpr std::string_view kOrigins =
    "SELECT case_id, quantity, value, analysis_version, window_start, window_end, recorded FROM quantities"
    " WHERE quantity IN ('batches', 'window_asked')";

std::unordered_map<std::string, ResultOrigin> origins_in(Statement rows) {
  std::unordered_map<std::string, ResultOrigin> all;
  while (rows.step()) {
    ResultOrigin& origin = all[rows.text(0)];
    if (rows.text(1) == "window_asked") {
      origin.window_asked = rows.optional_real(2);
      continue;
    }
    origin.analysis_version = static_cast<int>(rows.integer(3));
    origin.window_start = rows.real(4);
    origin.window_end = rows.real(5);
    origin.recorded = rows.text(6);
  }
  return all;
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
  static const std::string kOrigin = std::string(kOrigins) + " AND case_id = ?";
  const auto found = origins_in(connection_.query(kOrigin, case_id));
  return found.empty() ? std::nullopt : std::optional(found.begin()->second);
}

std::unordered_map<std::string, ResultOrigin> Store::result_origins() const {
  return origins_in(connection_.query(kOrigins));
}

}  // namespace softwall::campaign
