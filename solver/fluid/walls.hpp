#pragma once

#include "solver/grid/field.hpp"
#include "solver/grid/halo.hpp"

/// No-slip walls at y = 0 and y = height and, in a closed box, at x = 0 and x = length_x, as ghost cells; and
/// the ghost layers of velocity and pressure as a whole.
namespace softwall::fluid {

using grid::Real;

/// Velocity of the walls in y in their own plane, U_b; zero in a channel. Which walls in x this rank has;
/// they are at rest.
struct Walls {
  Real bottom_u = 0, top_u = 0;
  bool low_x = false, high_x = false;
};

/// The walls of a rank's part of the box, all at rest.
[[nodiscard]] Walls walls_of(const grid::Grid& grid);

/// Fills every ghost cell of a velocity: periodic neighbours, the normal component 0 on the walls (those at
/// low x are cells of the grid, u(0, j, k), those at high x ghost cells), the others mirrored about them.
void fill_ghosts(grid::VectorField& velocity, const Walls& walls, grid::Halo& halo);
/// Fills the remaining ones where the ghost cells in x of rows between the walls have been filled already.
void fill_other_ghosts(grid::VectorField& velocity, const Walls& walls, grid::Halo& halo);

/// Fills the ghost cells of a center field: periodic neighbours, zero gradient at the walls.
void fill_ghosts(grid::Field& center, grid::Halo& halo);

}  // namespace softwall::fluid
