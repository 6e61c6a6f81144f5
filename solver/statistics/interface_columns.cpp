#include "solver/statistics/interface_columns.hpp"

#include "solver/parallel/reduce.hpp"

namespace softwall::statistics {

namespace {

std::vector<InterfaceColumn> columns_of(const time::State& s, std::span<const double> heights,
                                        const grid::Grid& g) {
  const auto u = s.velocity.x.view(), v = s.velocity.y.view(), w = s.velocity.z.view(), p = s.pressure.view();
  const int above = g.ny_fluid, below = above - 1;
  const double share = (g.y_face[above] - g.y_center[below]) / g.dy_face[above];
  const auto between = [=](const auto& q, int i, int k) {
    return (1 - share) * q(i, below, k) + share * q(i, above, k);
  };
  std::vector<InterfaceColumn> columns;
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

}  // namespace

std::vector<InterfaceColumn> interface_columns(const time::State& s, std::span<const double> heights,
                                               const time::Setup& setup) {
  auto columns = columns_of(s, heights, setup.grid);
  InterfaceColumn mean{};
  for (const InterfaceColumn& c : columns) {
    for (std::size_t q = 0; q < mean.size(); ++q) mean[q] += c[q];
  }
  parallel::sum(setup.decomposition.all(), mean);
  for (InterfaceColumn& c : columns) {
    for (std::size_t q = 0; q < mean.size(); ++q)
      c[q] -= mean[q] / (double(setup.grid.nx_global) * setup.grid.nz_global);
  }
  return columns;
}

}  // namespace softwall::statistics
