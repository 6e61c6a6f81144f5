#include "analysis/jackknife.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/student_t.hpp"

// Delete-a-group jackknife for groups of unequal weight: Busing, Meijer & van der Leeden, Statistics and
// Computing 9 (1999) 3-8. Group j has the share 1/h_j of the weight; pseudo-value p_j = h_j t - (h_j - 1)
// t_(j); variance = mean over j of (p_j - mean)^2 / (h_j - 1).
namespace softwall::analysis {
namespace {

// Blocks are merged into fewer and fewer batches until those of a quantity are hardly correlated; where none
// are, the widest interval that any number of batches gives. (Trusting the fewest batches alone refused more
// intervals and covered less: the correlation of 8 numbers is hardly known, and is small by chance where the
// numbers lie close together.) More than 64 batches would sharpen Student's t no further.
constexpr std::array<int, 7> kBatchCounts = {64, 48, 32, 24, 16, 12, kLeastBatches};
constexpr double kCorrelationAllowed = 0.2;  // stop merging below this lag-1 correlation
constexpr double kLeastIndependent = 2.0;    // batches as good as fewer independent ones say nothing
constexpr double kCorrelationCaution = 0.3;  // times its standard error 1/sqrt(g), added before inflating
constexpr double kLeastDegrees = 3.0;

/// Batch of each block (-1: outside the window): neighbours together, of nearly equal weight.
std::vector<int> assign_batches(const std::vector<double>& weights, int batches) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<int> batch(weights.size(), -1);
  double before = 0.0;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    if (!(weights[b] > 0.0)) continue;
    const double middle = (before + 0.5 * weights[b]) / total;
    batch[b] = std::min(static_cast<int>(middle * batches), batches - 1);
    before += weights[b];
  }
  return batch;
}

struct Batches {
  std::vector<double> share;                // h_j
  std::vector<std::vector<double>> pseudo;  // [number][batch]
};

Batches pseudo_values(const std::vector<double>& weights, const std::vector<double>& full,
                      const Estimator& estimate, int count) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const std::vector<int> batch_of = assign_batches(weights, count);
  Batches result;
  result.pseudo.resize(full.size());
  for (int j = 0; j < count; ++j) {
    std::vector<double> kept = weights;
    double deleted = 0.0;
    for (std::size_t b = 0; b < kept.size(); ++b) {
      if (batch_of[b] == j) {
        deleted += kept[b];
        kept[b] = 0.0;
      }
    }
    if (!(deleted > 0.0)) continue;  // one long block can leave a batch empty
    const double h = total / deleted;
    const std::vector<double> without = estimate(kept);
    result.share.push_back(h);
    for (std::size_t q = 0; q < full.size(); ++q) {
      result.pseudo[q].push_back(h * full[q] - (h - 1.0) * without[q]);
    }
  }
  return result;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Lag-1 autocorrelation, corrected to first order for its bias in short samples of a first-order
/// autoregressive process, E[r] = rho - (1 + 4 rho)/g (Kendall 1954).
double lag_one(const std::vector<double>& values) {
  const double mean = mean_of(values), g = static_cast<double>(values.size());
  double product = 0.0, square = 0.0;
  for (std::size_t j = 0; j < values.size(); ++j) {
    square += (values[j] - mean) * (values[j] - mean);
    if (j > 0) product += (values[j] - mean) * (values[j - 1] - mean);
  }
  if (!(square > 0.0)) return 0.0;  // a constant is not correlated with anything
  return std::min((product / square + 1.0 / g) / (1.0 - 4.0 / g), 0.99);
}

/// By how much the correlation that is left widens the variance of the mean, and lessens the number of
/// batches that count, as for a first-order autoregressive process: (1 + r)/(1 - r).
double inflation_by(double correlation, std::size_t batches) {
  const double caution = kCorrelationCaution / std::sqrt(static_cast<double>(batches));
  const double r = std::max(correlation + caution, 0.0);
  return r < 1.0 ? (1.0 + r) / (1.0 - r) : std::numeric_limits<double>::infinity();
}

/// Jackknife interval.
double half_width(const std::vector<double>& pseudo, const std::vector<double>& share, double inflation) {
  const double g = static_cast<double>(pseudo.size()), mean = mean_of(pseudo);
  double variance = 0.0;
  for (std::size_t j = 0; j < pseudo.size(); ++j) {
    variance += (pseudo[j] - mean) * (pseudo[j] - mean) / (share[j] - 1.0) / g;
  }
  const double degrees = std::max(g / inflation - 1.0, kLeastDegrees);
  return student_t_975(degrees) * std::sqrt(variance * inflation);
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// What one number of batches says of a quantity.
struct Finding {
  Interval interval;
  bool is_settled = false;  ///< hardly correlated: fewer batches are not asked
};

Finding find(const std::vector<double>& pseudo, const std::vector<double>& share) {
  Finding finding{{{}, static_cast<int>(share.size()), ""}};
  if (!all_finite(pseudo)) {
    finding.interval.reason = "not defined when a part of the window is left out";
    return finding;
  }
  const double correlation = lag_one(pseudo), inflation = inflation_by(correlation, pseudo.size());
  if (finding.interval.batches < kLeastBatches || finding.interval.batches < kLeastIndependent * inflation) {
    finding.interval.reason = "parts of the window still correlated: average for longer";
    return finding;
  }
  finding.interval.ci95 = half_width(pseudo, share, inflation);
  finding.is_settled = correlation < kCorrelationAllowed;
  return finding;
}

/// Whether the finding takes the place of what more batches have said.
bool supersedes(const Finding& finding, const Interval& before) {
  if (!before.ci95 || finding.is_settled) return true;
  return finding.interval.ci95 && *finding.interval.ci95 > *before.ci95;
}

Interval too_short(int blocks) {
  return {{},
          0,
          "window too short for confidence intervals: " + std::to_string(blocks) + " blocks, " +
              std::to_string(kLeastBatches) + " needed"};
}

}  // namespace

std::vector<Interval> jackknife(const std::vector<double>& weights, const Estimator& estimate) {
  const std::vector<double> full = estimate(weights);
  const int blocks =
      static_cast<int>(std::count_if(weights.begin(), weights.end(), [](double w) { return w > 0; }));
  if (blocks < kLeastBatches) return std::vector<Interval>(full.size(), too_short(blocks));
  std::vector<Interval> intervals(full.size());
  std::vector<bool> settled(full.size(), false);
  int previous = 0;
  for (const int wanted : kBatchCounts) {
    const int count = std::min(wanted, blocks);
    if (count == previous || std::all_of(settled.begin(), settled.end(), [](bool s) { return s; })) continue;
    previous = count;
    const Batches batches = pseudo_values(weights, full, estimate, count);
    for (std::size_t q = 0; q < full.size(); ++q) {
      if (settled[q]) continue;
      const Finding finding = find(batches.pseudo[q], batches.share);
      if (supersedes(finding, intervals[q])) intervals[q] = finding.interval;
      settled[q] = finding.is_settled;
    }
  }
  return intervals;
}

}  // namespace softwall::analysis
