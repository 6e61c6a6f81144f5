#include "solver/fluid/forcing.hpp"

#include <array>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"

namespace softwall::fluid {

double hold_flow_rate(grid::VectorField& velocity, const SolidInput& solid, double bulk_velocity,
                      const Grid& g, const parallel::Decomposition& decomposition) {
  const auto u = velocity.x.view();
  const double* dy = g.dy.exact();
  const int solid_row = solid.fraction ? solid.first_row : g.ny;
  std::array<double, 2> flow_and_volume{};
  flow_and_volume[0] =
      grid::sum_cells(grid::rows(g, 0, solid_row), [=](int i, int j, int k) { return u(i, j, k) * dy[j]; });
  flow_and_volume[1] = double(g.nx) * g.nz * (g.y_face[solid_row] - g.y_face[0]);
  if (solid_row < g.ny) {
    const auto phi = solid.fraction->view();
    const auto box = grid::rows(g, solid_row, g.ny);
    const auto fluid_volume = [=](int i, int j, int k) {
      return (1 - (phi(i, j, k) + phi(i - 1, j, k)) / 2) * dy[j];
    };
    flow_and_volume[0] +=
        grid::sum_cells(box, [=](int i, int j, int k) { return fluid_volume(i, j, k) * u(i, j, k); });
    flow_and_volume[1] += grid::sum_cells(box, fluid_volume);
  }
  parallel::sum(decomposition.all(), flow_and_volume);
  const double missing = bulk_velocity - flow_and_volume[0] / flow_and_volume[1];
  const Real more = Real(missing);
  grid::for_each_cell(grid::all_cells(g), [=](int i, int j, int k) { u(i, j, k) += more; });
  return missing;
}

}  // namespace softwall::fluid
