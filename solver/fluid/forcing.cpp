#include "solver/fluid/forcing.hpp"

#include <algorithm>
#include <array>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"

namespace softwall::fluid {

namespace {

int solid_row(const SolidInput& solid, const Grid& g) { return solid.fraction ? solid.first_row : g.ny; }

/// Flow rate and volume of the fluid, over dx dz.
struct Flow {
  double flow = 0, volume = 0;
};

/// The flow through the rows that hold no solid, where it is known.
Flow below_solid(double flow, const SolidInput& solid, const Grid& g) {
  return {flow, double(g.nx) * g.nz * (g.y_face[solid_row(solid, g)] - g.y_face[0])};
}

/// Adds the rows that hold solid and fluid; u(i, j, k) is the velocity there.
template <class Velocity>
void add_beside_solid(Flow& total, const SolidInput& solid, const Grid& g, const Velocity& u) {
  if (!solid.fraction) return;
  const auto phi = solid.fraction->view();
  const int end = std::min(solid.fluid_end_row, g.ny);
  for (int k = 0; k < g.nz; ++k) {
    for (int j = solid.first_row; j < end; ++j) {
      double flow = 0, volume = 0;
#pragma omp simd reduction(+ : flow, volume)
      for (int i = 0; i < g.nx; ++i) {
        const double fluid = 1 - (phi(i, j, k) + phi(i - 1, j, k)) / 2;
        volume += fluid;
        flow += fluid * u(i, j, k);
      }
      total.flow += flow * g.dy[j];
      total.volume += volume * g.dy[j];
    }
  }
}

double missing(const Flow& here, double bulk_velocity, const parallel::Decomposition& decomposition) {
  std::array<double, 2> all{here.flow, here.volume};
  parallel::sum(decomposition.all(), all);
  return bulk_velocity - all[0] / all[1];
}

}  // namespace

/// Over a whole row the sum of d psi/dx is zero: psi is periodic.
double flow_rate_correction(const PendingVelocity& velocity, const SolidInput& solid, double bulk_velocity,
                            const Grid& g, const parallel::Decomposition& decomposition) {
  double flow = 0;
  for (int j = 0; j < solid_row(solid, g); ++j)
    flow += velocity.row_sums[static_cast<std::size_t>(j)] * g.dy[j];
  Flow here = below_solid(flow, solid, g);
  const auto u = velocity.predicted.view(), psi = velocity.psi.view();
  const Real by_x = Real(velocity.duration / g.dx);
  add_beside_solid(here, solid, g, [=](int i, int j, int k) {
    return u(i, j, k) - by_x * (psi(i, j, k) - psi(i - 1, j, k));
  });
  return missing(here, bulk_velocity, decomposition);
}

double hold_flow_rate(grid::VectorField& velocity, const SolidInput& solid, double bulk_velocity,
                      const Grid& g, const parallel::Decomposition& decomposition) {
  const auto u = velocity.x.view();
  const double* dy = g.dy.exact();
  const double flow = grid::sum_cells(grid::rows(g, 0, solid_row(solid, g)),
                                      [=](int i, int j, int k) { return u(i, j, k) * dy[j]; });
  Flow here = below_solid(flow, solid, g);
  add_beside_solid(here, solid, g, u);
  const double amount = missing(here, bulk_velocity, decomposition);
  const Real more = Real(amount);
  grid::for_each_cell(grid::all_cells(g), [=](int i, int j, int k) { u(i, j, k) += more; });
  return amount;
}

}  // namespace softwall::fluid
