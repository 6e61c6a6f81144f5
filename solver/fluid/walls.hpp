#pragma once

#include "solver/grid/field.hpp"
#include "solver/grid/halo.hpp"

/// No-slip walls at y = 0 and y = height, as ghost rows; and the ghost layers of velocity and pressure as a
/// whole.
namespace softwall::fluid {

using grid::Real;

/// Velocity of the walls in their own plane, U_b. Zero in a channel.
struct Walls {
  Real bottom_u = 0, top_u = 0;
};

/// Fills every ghost cell of a velocity: periodic neighbours, v = 0 on the walls, u and w mirrored about
/// them.
void fill_ghosts(grid::VectorField& velocity, const Walls& walls, grid::Halo& halo);

/// Fills the ghost cells of a center field: periodic neighbours, zero gradient at the walls.
void fill_ghosts(grid::Field& center, grid::Halo& halo);

}  // namespace softwall::fluid
