#include "solver/time/fastest_layout.hpp"

#include <algorithm>
#include <limits>

#include "solver/grid/halo.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/pressure/projection.hpp"

namespace softwall::time {

namespace {

constexpr int kRepetitions = 10;

/// Seconds of the slowest rank; the best of some repetitions, since disturbances only ever add.
double seconds_of_a_substep(const Physics& physics, const parallel::Communicator& world,
                            const parallel::Layout& layout) {
  const parallel::Decomposition decomposition(world.get(), physics.grid.nx, physics.grid.nz, layout);
  const grid::Grid grid = grid::make_grid(physics, decomposition);
  grid::Halo halo(decomposition);
  pressure::Projection projection(grid, decomposition, halo);
  grid::VectorField velocity(grid, 1);
  grid::Field pressure(grid, 1);
  double best = std::numeric_limits<double>::infinity();
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    parallel::check(MPI_Barrier(world.get()), "MPI_Barrier");
    const double begin = MPI_Wtime();
    projection.project(velocity, pressure, kRungeKutta3[0], 1);
    halo.fill_in_z({&velocity.x, &velocity.y, &velocity.z}, {-1, grid.ny + 1});
    best = std::min(best, parallel::maximum(world, MPI_Wtime() - begin));
  }
  return best;
}

}  // namespace

parallel::Layout fastest_layout(const Physics& physics, const parallel::Communicator& world) {
  const auto possible = parallel::possible_layouts(world.size(), physics.grid.nx, physics.grid.nz);
  if (possible.size() == 1) return possible.front();
  parallel::Layout fastest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& layout : possible) {
    const double seconds = seconds_of_a_substep(physics, world, layout);
    if (seconds < least) {
      least = seconds;
      fastest = layout;
    }
  }
  return fastest;
}

}  // namespace softwall::time
