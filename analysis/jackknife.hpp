#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// 95 % confidence intervals of numbers derived from means over correlated blocks. analysis/README.md,
/// "Uncertainty", gives the recipe, its reason and its measured coverage.
namespace softwall::analysis {

/// The numbers derived from the mean over the blocks with these weights (0: block left out). May hold NaN.
using Estimator = std::function<std::vector<double>(const std::vector<double>& weights)>;

struct Interval {
  std::optional<double> ci95;  ///< half width; empty when the window cannot give one
  int batches = 0;             ///< on which it rests
  std::string reason;          ///< in words, when empty
};

inline constexpr int kLeastBatches = 8;  ///< fewer give no interval

/// One interval for each number of the estimator. `weights` are the sampled times of the blocks of the
/// window, 0 for blocks outside it.
[[nodiscard]] std::vector<Interval> jackknife(const std::vector<double>& weights, const Estimator& estimate);

}  // namespace softwall::analysis
