#include "campaign/store/store.hpp"
#include "campaign/system/clock.hpp"
#include "solver/run_directory/build_info.hpp"

namespace softwall::campaign {

namespace {

using analysis::DerivedQuantities;

/// Details of the average and of the log-law fit, stored beside the measured quantities but without interval.
struct Detail {
  std::string_view name;
  double DerivedQuantities::*member;
};
constexpr std::array<Detail, 6> kDetails = {{
    {"log_range_low_plus", &DerivedQuantities::log_range_low_plus},
    {"log_range_high_plus", &DerivedQuantities::log_range_high_plus},
    {"log_residual", &DerivedQuantities::log_residual},
    {"log_intercept", &DerivedQuantities::log_intercept},
    {"stress_balance_residual", &DerivedQuantities::stress_balance_residual},
    {"sampled_time", &DerivedQuantities::sampled_time},
}};

}  // namespace

void Store::record_result(const std::string& case_id, const DerivedQuantities& derived,
                          const std::string& git_revision) {
  const std::string now = utc_text(std::chrono::system_clock::now());
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

std::optional<ResultOrigin> Store::result_origin(const std::string& case_id) const {
  Statement found = connection_.query(
      "SELECT analysis_version, window_start, window_end, recorded FROM quantities WHERE case_id = ? LIMIT 1",
      case_id);
  if (!found.step()) return std::nullopt;
  return ResultOrigin{static_cast<int>(found.integer(0)), found.real(1), found.real(2), found.text(3)};
}

std::unordered_map<std::string, ResultOrigin> Store::result_origins() const {
  // Every result has this quantity; those of one result have the same origin.
  Statement rows = connection_.prepare(
      "SELECT case_id, analysis_version, window_start, window_end, recorded FROM quantities"
      " WHERE quantity = 'batches'");
  std::unordered_map<std::string, ResultOrigin> all;
  while (rows.step()) {
    all[rows.text(0)] = {static_cast<int>(rows.integer(1)), rows.real(2), rows.real(3), rows.text(4)};
  }
  return all;
}

}  // namespace softwall::campaign
