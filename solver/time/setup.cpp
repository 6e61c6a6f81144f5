#include "solver/time/setup.hpp"

namespace softwall::time {

Setup::Setup(const Physics& p, MPI_Comm comm, std::optional<parallel::Layout> layout)
    : physics(p),
      decomposition(comm, p.grid.nx, p.grid.nz, layout),
      grid(grid::make_grid(p, decomposition)),
      viscosity(1.0 / p.reynolds),
      halo(decomposition),
      predictor(grid, viscosity),
      projection(grid, decomposition, halo) {
  if (p.solid) solid.emplace(*p.solid, grid, decomposition, halo);
}

}  // namespace softwall::time
