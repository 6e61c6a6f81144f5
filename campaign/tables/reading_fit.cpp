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

/// Adds the squares of the departures of one case; returns how many there are.
int add_squares(const MeasuredCase& measured, const PaperCase& paper, double& sum) {
  int values = 0;
  for (const char* column : kCompared) {
    const auto found = measured.value(column).value;
    const auto printed = paper.number(column);
    if (!found || !printed) continue;
    const double departure = (*found - *printed) / range_of(column);
    sum += departure * departure;
    ++values;
  }
  return values;
}

}  // namespace

std::vector<ReadingFit> reading_fits(const std::vector<MeasuredCase>& cases) {
  const std::vector<MeasuredCase> finest = finest_of_each(cases);
  std::vector<ReadingFit> fits;
  for (const Reading& reading : kReadings) {
    ReadingFit fit{.reading = &reading};
    double sum = 0;
    for (const MeasuredCase& measured : finest) {
      for (const PaperCase& paper : paper_cases()) {
        if (!paper.g_table || !is_match(measured, paper, reading)) continue;
        const int values = add_squares(measured, paper, sum);
        fit.values += values;
        fit.cases += values > 0 ? 1 : 0;
      }
    }
    if (fit.values > 0) fit.departure = std::sqrt(sum / fit.values);
    fits.push_back(fit);
  }
  return fits;
}

const ReadingFit* best_of(const std::vector<ReadingFit>& fits) {
  const ReadingFit* best = nullptr;
  for (const ReadingFit& fit : fits) {
    if (fit.values > 0 && (best == nullptr || fit.departure < best->departure)) best = &fit;
  }
  return best;
}

}  // namespace softwall::campaign
