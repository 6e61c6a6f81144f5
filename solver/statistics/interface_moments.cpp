#include "solver/statistics/interface_moments.hpp"

#include <algorithm>
#include <cmath>

#include "solver/parallel/reduce.hpp"

namespace softwall::statistics {

namespace {

/// In the order of kInterfaceMoments.
std::array<double, kInterfaceMoments.size()> products(const InterfaceColumn& c) {
  const auto [u, v, w, p, eta] = c;
  const double square = eta * eta;
  return {square, square * eta, square * square, u * u,   v * v,   w * w,  p * p,
          u * v,  u * p,        v * p,           u * eta, v * eta, p * eta};
}

double layer_thickness(const grid::Grid& g) { return g.y_face[g.ny] - g.y_face[g.ny_fluid]; }

/// The first bin where the height is no number, as in a flow that has just diverged.
std::size_t bin_of(double height, double thickness) {
  const double place = (height / thickness + 1) / 2 * kHeightBins;
  return place > 0 ? static_cast<std::size_t>(std::min(place, kHeightBins - 1.0)) : 0;
}

}  // namespace

std::vector<double> height_bin_edges(const grid::Grid& g) {
  std::vector<double> edges;
  for (int n = 0; n <= kHeightBins; ++n) edges.push_back(layer_thickness(g) * (2.0 * n / kHeightBins - 1));
  return edges;
}

std::vector<double> interface_sample(std::span<const InterfaceColumn> columns, const time::Setup& setup) {
  const auto& g = setup.grid;
  std::vector<double> sample(kInterfaceMoments.size() + kHeightBins);
  for (const InterfaceColumn& c : columns) {
    const auto moments = products(c);
    for (std::size_t n = 0; n < moments.size(); ++n) sample[n] += moments[n];
    sample[moments.size() + bin_of(c.back(), layer_thickness(g))] += 1;
  }
  parallel::sum(setup.decomposition.all(), sample);
  for (double& value : sample) value /= double(g.nx_global) * g.nz_global;
  return sample;
}

}  // namespace softwall::statistics
