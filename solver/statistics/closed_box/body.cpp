#include "solver/statistics/closed_box/body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/case/elastic_law.hpp"
#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/solid/cofactors.hpp"

namespace softwall::statistics {

namespace {

using grid::Grid;
using Phi = grid::View<const grid::Real>;

constexpr double kLevel = 0.5;

struct Sums {
  double area = 0, x = 0, y = 0, mixed = 0, outline = 0;
};

/// One cell's share of every sum; gradients are central.
void add_cell(const Phi& phi, const Grid& g, std::array<int, 3> at, Sums& sums) {
  const auto [i, j, k] = at;
  const double here = phi(i, j, k), area = g.dx * g.dy[j];
  const double in_x = (phi(i + 1, j, k) - phi(i - 1, j, k)) / (2 * g.dx);
  const double in_y = (phi(i, j + 1, k) - phi(i, j - 1, k)) / (g.dy_face[j] + g.dy_face[j + 1]);
  sums.area += area * here;
  sums.x += area * here * (g.x_begin + i + 0.5) * g.dx;
  sums.y += area * here * g.y_center[j];
  sums.mixed += area * 4 * here * (1 - here);
  sums.outline += area * std::sqrt(in_x * in_x + in_y * in_y);
}

struct Reach {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

/// Widens the reach by the crossing of the level between two centers, if there is one.
void include(double here, double next, double at, double distance, Reach& reach) {
  if ((here < kLevel) == (next < kLevel)) return;
  const double crossing = at + distance * (kLevel - here) / (next - here);
  reach.low = std::min(reach.low, crossing);
  reach.high = std::max(reach.high, crossing);
}

}  // namespace

Body body_of(const grid::Field& field, const Grid& g, const parallel::Decomposition& decomposition) {
  const auto phi = field.view();
  Sums sums;
  Reach in_x, in_y;
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        add_cell(phi, g, {i, j, k}, sums);
        include(phi(i, j, k), phi(i + 1, j, k), (g.x_begin + i + 0.5) * g.dx, g.dx, in_x);
        include(phi(i, j, k), phi(i, j + 1, k), g.y_center[j], g.dy_face[j + 1], in_y);
      }
    }
  }
  const auto& all = decomposition.all();
  std::array<double, 5> total{sums.area, sums.x, sums.y, sums.mixed, sums.outline};
  parallel::sum(all, total);
  return {.centroid_x = total[1] / total[0],
          .centroid_y = total[2] / total[0],
          .area = total[0] / g.nz_global,
          .x_min = parallel::minimum(all, in_x.low),
          .x_max = parallel::maximum(all, in_x.high),
          .y_min = parallel::minimum(all, in_y.low),
          .y_max = parallel::maximum(all, in_y.high),
          .width_cells = 0.8 * 1.5 * total[3] / (total[4] * g.dx)};
}

BoxEnergy energy_of(const time::State& s, const time::Setup& setup) {
  const auto& g = setup.grid;
  const auto u = s.velocity.x.view(), v = s.velocity.y.view();
  const double* dy = g.dy.exact();
  const auto box = grid::all_cells(g);
  std::array<double, 2> energy{};
  energy[0] = grid::sum_cells(box, [=](int i, int j, int k) {
    const double a = u(i, j, k), b = u(i + 1, j, k), c = v(i, j, k), d = v(i, j + 1, k);
    return (a * a + b * b + c * c + d * d) / 4 * dy[j];
  });
  if (s.elastic) {
    const auto phi = s.material.phi.view(), xx = s.material.B.xx.view(), yy = s.material.B.yy.view(),
               zz = s.material.B.zz.view();
    const auto law = law_of<double>(*setup.physics.solid);
    const auto trace = [=](int i, int j, int k) { return double(xx(i, j, k)) + yy(i, j, k) + zz(i, j, k); };
    const solid::Cofactors C = solid::cofactors_of(s.material, g);
    energy[1] =
        law.is_neo_hookean()
            ? grid::sum_cells(
                  box, [=](int i, int j, int k) { return phi(i, j, k) * law.energy(trace(i, j, k)) * dy[j]; })
            : grid::sum_cells(box, [=](int i, int j, int k) {
                const double of_C = double(C.xx(i, j, k)) + C.yy(i, j, k) + C.zz(i, j, k);
                return phi(i, j, k) * law.energy(trace(i, j, k), of_C) * dy[j];
              });
  }
  parallel::sum(setup.decomposition.all(), energy);
  return {energy[0] * g.dx / g.nz_global, energy[1] * g.dx / g.nz_global};
}

}  // namespace softwall::statistics
