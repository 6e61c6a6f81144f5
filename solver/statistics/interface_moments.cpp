#include "solver/statistics/interface_moments.hpp"

#include <algorithm>
#include <cmath>

#include "solver/parallel/reduce.hpp"

namespace softwall::statistics {

namespace {

using Column = std::array<double, 5>;  // u, v, w, p, eta

/// Of every column of this rank, i + nx k.
std::vector<Column> columns_of(const time::State& s, std::span<const double> heights, const grid::Grid& g) {
  const auto u = s.velocity.x.view(), v = s.velocity.y.view(), w = s.velocity.z.view(), p = s.pressure.view();
  const int above = g.ny_fluid, below = above - 1;
  const double share = (g.y_face[above] - g.y_center[below]) / g.dy_face[above];
  const auto between = [=](const auto& q, int i, int k) {
    return (1 - share) * q(i, below, k) + share * q(i, above, k);
  };
  std::vector<Column> columns;
  columns.reserve(heights.size());
  for (int k = 0; k < g.nz; ++k) {
    for (int i = 0; i < g.nx; ++i) {
      columns.push_back({(between(u, i, k) + between(u, i + 1, k)) / 2, v(i, above, k),
                         (between(w, i, k) + between(w, i, k + 1)) / 2, between(p, i, k),
                         heights[columns.size()]});
    }
  }
  return columns;
}

/// Their values less the mean over the plane.
void make_fluctuations(std::vector<Column>& columns, const time::Setup& setup) {
  Column mean{};
  for (const Column& c : columns) {
    for (std::size_t q = 0; q < mean.size(); ++q) mean[q] += c[q];
  }
  parallel::sum(setup.decomposition.all(), mean);
  for (Column& c : columns) {
    for (std::size_t q = 0; q < mean.size(); ++q)
      c[q] -= mean[q] / (double(setup.grid.nx_global) * setup.grid.nz_global);
  }
}

/// In the order of kInterfaceMoments.
std::array<double, kInterfaceMoments.size()> products(const Column& c) {
  const auto [u, v, w, p, eta] = c;
  const double square = eta * eta;
  return {square, square * eta, square * square, u * u,   v * v,   w * w,  p * p,
          u * v,  u * p,        v * p,           u * eta, v * eta, p * eta};
}

double layer_thickness(const grid::Grid& g) { return g.y_face[g.ny] - g.y_face[g.ny_fluid]; }

std::size_t bin_of(double height, double thickness) {
  const double place = (height / thickness + 1) / 2 * kHeightBins;
  return static_cast<std::size_t>(std::clamp(place, 0.0, kHeightBins - 1.0));
}

}  // namespace

std::vector<double> height_bin_edges(const grid::Grid& g) {
  std::vector<double> edges;
  for (int n = 0; n <= kHeightBins; ++n) edges.push_back(layer_thickness(g) * (2.0 * n / kHeightBins - 1));
  return edges;
}

std::vector<double> interface_sample(const time::State& s, std::span<const double> heights,
                                     const time::Setup& setup) {
  const auto& g = setup.grid;
  auto columns = columns_of(s, heights, g);
  make_fluctuations(columns, setup);
  std::vector<double> sample(kInterfaceMoments.size() + kHeightBins);
  for (const Column& c : columns) {
    const auto moments = products(c);
    for (std::size_t n = 0; n < moments.size(); ++n) sample[n] += moments[n];
    sample[moments.size() + bin_of(c.back(), layer_thickness(g))] += 1;
  }
  parallel::sum(setup.decomposition.all(), sample);
  for (double& value : sample) value /= double(g.nx_global) * g.nz_global;
  return sample;
}

}  // namespace softwall::statistics
