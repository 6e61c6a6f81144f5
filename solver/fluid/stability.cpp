#include "solver/fluid/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/case/step_limits.hpp"
#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"

namespace softwall::fluid {

double convection_rate_here(const grid::VectorField& velocity, const Grid& g) {
  constexpr Real kInfinite = std::numeric_limits<Real>::infinity();
  const auto u = velocity.x.view(), v = velocity.y.view(), w = velocity.z.view();
  const Real inv_dx = Real(1 / g.dx), inv_dz = Real(1 / g.dz);
  const Real* inv_dy = g.inv_dy.data();
  return grid::max_cells(grid::all_cells(g), 0.0, [=](int i, int j, int k) {
    const Real rate = std::abs(u(i, j, k)) * inv_dx +
                      std::max(std::abs(v(i, j, k)), std::abs(v(i, j + 1, k))) * inv_dy[j] +
                      std::abs(w(i, j, k)) * inv_dz;
    return rate < kInfinite ? rate : kInfinite;  // NaN compares false
  });
}

double convection_rate(const grid::VectorField& velocity, const Grid& g,
                       const parallel::Decomposition& decomposition) {
  return parallel::maximum(decomposition.all(), convection_rate_here(velocity, g));
}

double moving_wall_limit(const Walls& walls, const Grid& g) {
  const double fastest = std::max(std::abs(walls.bottom_u), std::abs(walls.top_u));
  return step_limits::convection(fastest / g.dx);
}

namespace {

/// Viscosity over the fluid's that bounds the rate at which a row of the band relaxes in y: by Gershgorin,
/// a quarter of the absolute sum of a row of the matrix, which is 4 for the fluid alone. The worst row is the
/// lowest of the solid: 3 c through the interface, where c (g - g_s / 2) counts, and 2 mu_s / mu_f above it.
double across_the_interface(const SolidInput& solid) {
  const double c = solid.interface_viscosity, r = solid.ratio_across;
  return c > 1 ? std::max(r, (3 * c + 2 * r) / 4) : std::max(1.0, r);
}

}  // namespace

double viscosity_limit(double viscosity, const SolidInput& solid, const Grid& g) {
  double limit = std::numeric_limits<double>::infinity();
  for (int j = 0; j < g.ny; ++j) {
    const bool holds_solid = solid.fraction && j >= solid.first_row;
    const double along = holds_solid ? std::max(1.0, solid.viscosity_ratio) : 1,
                 across = holds_solid ? across_the_interface(solid) : 1;
    const double rate = along / (g.dx * g.dx) + across * g.inv_dy[j] * g.inv_dy[j] + along / (g.dz * g.dz);
    limit = std::min(limit, step_limits::viscosity(viscosity, rate));
  }
  return limit;
}

}  // namespace softwall::fluid
