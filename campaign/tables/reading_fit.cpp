#include "campaign/tables/reading_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "campaign/tables/grid_convergence.hpp"

namespace softwall::campaign {
namespace {

constexpr std::array<const char*, 6> kCompared = {"re_tau_w", "re_tau",    "u_max",
                                                  "y_max",    "delta_max", "delta_rms"};

double range_of(const char* column) {
  std::vector<double> values;
  for (const PaperCase& paper : paper_cases()) {
    if (const auto value = paper.number(column)) values.push_back(*value);
  }
  const auto [least, most] = std::ranges::minmax(values);
  return most - least;
}

/// Sum of the squares of departures while it is being added up.
struct Squares {
  double sum = 0;
  int values = 0, rows = 0;

  void add(const Squares& more) {
    sum += more.sum;
    values += more.values;
    rows += more.rows;
  }
  [[nodiscard]] Departure departure() const {
    return {values > 0 ? std::sqrt(sum / values) : 0.0, values, rows};
  }
};

void add_case(const MeasuredCase& measured, const PaperCase& paper, Squares& to) {
  for (const char* column : kCompared) {
    const auto found = measured.value(column).value;
    const auto printed = paper.number(column);
    if (!found || !printed) continue;
    const double departure = (*found - *printed) / range_of(column);
    to.sum += departure * departure;
    ++to.values;
  }
}

/// Of each of the paper's rows, in their order; that of the rigid channel, and what has no result, is empty.
std::vector<Squares> by_row(const Reading& reading, const std::vector<MeasuredCase>& cases) {
  std::vector<Squares> rows;
  for (const PaperCase& paper : paper_cases()) {
    Squares& row = rows.emplace_back();
    if (!paper.g_table) continue;
    for (const MeasuredCase& measured : cases)
      if (is_match(measured, paper, reading)) add_case(measured, paper, row);
    row.rows = row.values > 0 ? 1 : 0;
  }
  return rows;
}

}  // namespace

std::vector<ReadingFit> reading_fits(const std::vector<MeasuredCase>& cases) {
  const std::vector<MeasuredCase> finest = finest_of_each(cases);
  std::vector<std::vector<Squares>> of_readings;
  for (const Reading& reading : kReadings) of_readings.push_back(by_row(reading, finest));
  const auto is_shared = [&](std::size_t row) {
    return std::ranges::all_of(of_readings, [row](const auto& rows) { return rows[row].values > 0; });
  };
  std::vector<ReadingFit> fits;
  for (std::size_t n = 0; n < kReadings.size(); ++n) {
    Squares all, shared;
    for (std::size_t row = 0; row < of_readings[n].size(); ++row) {
      all.add(of_readings[n][row]);
      if (is_shared(row)) shared.add(of_readings[n][row]);
    }
    fits.push_back({&kReadings[n], all.departure(), shared.departure()});
  }
  return fits;
}

const ReadingFit* best_of(const std::vector<ReadingFit>& fits) {
  const auto best = std::ranges::min_element(fits, {}, [](const ReadingFit& fit) { return fit.shared.rms; });
  return best != fits.end() && best->shared.values > 0 ? &*best : nullptr;
}

}  // namespace softwall::campaign
