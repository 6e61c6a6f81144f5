#include "solver/statistics/interface_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "solver/parallel/reduce.hpp"

namespace softwall::statistics {

namespace {

constexpr double kStretching = 6;

double half_range(std::string_view quantity, const grid::Grid& g) {
  if (quantity == "v") return 1;
  if (quantity == "p") return 0.5;
  if (quantity == "eta") return g.y_face[g.ny] - g.y_face[g.ny_fluid];
  throw std::out_of_range("no bins for " + std::string(quantity));
}

double value_in(const InterfaceColumn& c, std::string_view quantity) {
  const auto [u, v, w, p, eta] = c;
  return quantity == "v" ? v : quantity == "p" ? p : eta;
}

std::size_t bin_of(double value, const std::vector<double>& edges) {
  const auto inner = std::span(edges).subspan(1, kPairBins - 1);
  return static_cast<std::size_t>(std::ranges::upper_bound(inner, value) - inner.begin());
}

/// The bin of one quantity of every column.
std::vector<std::size_t> bins_of(std::span<const InterfaceColumn> columns, std::string_view quantity,
                                 const grid::Grid& g) {
  const auto edges = pair_bin_edges(quantity, g);
  std::vector<std::size_t> bins;
  bins.reserve(columns.size());
  for (const InterfaceColumn& c : columns) bins.push_back(bin_of(value_in(c, quantity), edges));
  return bins;
}

}  // namespace

std::vector<double> pair_bin_edges(std::string_view quantity, const grid::Grid& g) {
  const double scale = half_range(quantity, g) / std::sinh(kStretching);
  std::vector<double> edges;
  for (int n = 0; n <= kPairBins; ++n)
    edges.push_back(scale * std::sinh(kStretching * (2.0 * n - kPairBins) / kPairBins));
  return edges;
}

std::vector<double> interface_pair_sample(std::span<const InterfaceColumn> columns,
                                          const time::Setup& setup) {
  const auto& g = setup.grid;
  std::map<std::string_view, std::vector<std::size_t>> bins;
  for (const auto quantity : kBinnedQuantities) bins[quantity] = bins_of(columns, quantity, g);
  std::vector<double> sample(kPairValues);
  auto* histogram = sample.data();
  for (const InterfacePair& pair : kInterfacePairs) {
    const auto &first = bins.at(pair.first), &second = bins.at(pair.second);
    for (std::size_t n = 0; n < columns.size(); ++n) histogram[first[n] * kPairBins + second[n]] += 1;
    histogram += kPairBins * kPairBins;
  }
  parallel::sum(setup.decomposition.all(), sample);
  for (double& value : sample) value /= double(g.nx_global) * g.nz_global;
  return sample;
}

}  // namespace softwall::statistics
