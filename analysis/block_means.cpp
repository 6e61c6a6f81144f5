#include "analysis/block_means.hpp"

#include <numeric>
#include <stdexcept>

namespace softwall::analysis {
namespace {

double total_weight(const std::vector<double>& weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(total > 0.0)) throw std::runtime_error("no statistics were sampled in the averaging window");
  return total;
}

}  // namespace

double mean_series(const BlockStatistics& statistics, const std::string& name,
                   const std::vector<double>& weights) {
  const auto found = statistics.series.find(name);
  if (found == statistics.series.end()) throw std::runtime_error("the statistics hold no series " + name);
  const double total = total_weight(weights);
  double sum = 0.0;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    // A block without weight may hold 0/0.
    if (weights[b] > 0.0) sum += weights[b] * found->second[b];
  }
  return sum / total;
}

std::vector<double> mean_profile(const BlockStatistics& statistics, const std::string& name,
                                 const std::vector<double>& weights) {
  const auto found = statistics.profiles.find(name);
  if (found == statistics.profiles.end()) throw std::runtime_error("the statistics hold no profile " + name);
  const double total = total_weight(weights);
  const std::size_t points = statistics.points(found->second.location);
  std::vector<double> mean(points, 0.0);
  for (std::size_t b = 0; b < weights.size(); ++b) {
    if (!(weights[b] > 0.0)) continue;
    const double* values = found->second.values.data() + b * points;
    for (std::size_t j = 0; j < points; ++j) mean[j] += weights[b] * values[j];
  }
  for (double& value : mean) value /= total;
  return mean;
}

}  // namespace softwall::analysis
