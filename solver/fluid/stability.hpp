#pragma once

#include "solver/fluid/predictor.hpp"
#include "solver/fluid/walls.hpp"
#include "solver/parallel/decomposition.hpp"

/// Largest stable time steps of convection and viscosity for the three-substep Runge-Kutta scheme with
/// central differences (case/step_limits.hpp).
namespace softwall::fluid {

/// Largest |u|/dx + |v|/dy + |w|/dz of this rank's cells, U_b / h; infinite when a velocity is not a number.
[[nodiscard]] double convection_rate_here(const grid::VectorField& velocity, const Grid& grid);
/// The largest over the cells of all ranks.
[[nodiscard]] double convection_rate(const grid::VectorField& velocity, const Grid& grid,
                                     const parallel::Decomposition& decomposition);

/// The convection limit of the fluid that a moving wall will set in motion, sqrt(3) dx / |u_wall|: a flow at
/// rest has no other. Infinite when the walls are at rest.
[[nodiscard]] double moving_wall_limit(const Walls& walls, const Grid& grid);

/// 2.51 / (4 nu_max (1/dx^2 + 1/dy^2 + 1/dz^2)), the smallest over the rows; the solid's viscosity counts
/// from its first row on.
[[nodiscard]] double viscosity_limit(double viscosity, const SolidInput& solid, const Grid& grid);

}  // namespace softwall::fluid
