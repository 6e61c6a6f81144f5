#include "solver/time/setup.hpp"

namespace softwall::time {

namespace {

fluid::Walls moving_walls(const Physics& p, const grid::Grid& g) {
  fluid::Walls walls = fluid::walls_of(g);
  if (p.flow == FlowType::kCavity) walls.top_u = 1;
  return walls;
}

bool is_implicit(const Physics& p) { return p.time_step.viscosity == ViscousTerms::kImplicit; }

std::optional<double> driven_at(const Physics& p) {
  return p.is_driven() ? std::optional(1.0) : std::nullopt;
}

}  // namespace

Setup::Setup(const Physics& p, MPI_Comm comm, std::optional<parallel::Layout> layout)
    : physics(p),
      decomposition(comm, p.grid.nx, p.grid.nz, layout),
      grid(grid::make_grid(p, decomposition)),
      viscosity(1.0 / p.reynolds),
      walls(moving_walls(p, grid)),
      bulk_velocity(driven_at(p)),
      velocity_prescribed(p.flow == FlowType::kRotation),
      halo(decomposition, grid.walls_in_x, &profile),
      predictor(grid, is_implicit(p) ? 0 : viscosity) {
  if (is_closed_box(p.flow)) {
    box_projection.emplace(grid, decomposition, halo);
  } else {
    projection.emplace(grid, decomposition, halo, &profile);
  }
  if (is_implicit(p)) implicit_viscosity.emplace(grid, decomposition, viscosity);
  if (p.solid) solid.emplace(*p.solid, grid, decomposition, halo);
}

}  // namespace softwall::time
