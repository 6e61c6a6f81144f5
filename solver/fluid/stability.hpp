#pragma once

#include "solver/fluid/predictor.hpp"
#include "solver/parallel/decomposition.hpp"

/// Largest stable time steps of convection and viscosity for the three-substep Runge-Kutta scheme with
/// central differences: its stability region reaches sqrt(3) on the imaginary axis and 2.51 on the negative
/// real axis.
namespace softwall::fluid {

/// sqrt(3) / max(|u|/dx + |v|/dy + |w|/dz); infinite for a fluid at rest.
[[nodiscard]] double convection_limit(const grid::VectorField& velocity, const Grid& grid,
                                      const parallel::Decomposition& decomposition);

/// 2.51 / (4 nu_max (1/dx^2 + 1/dy^2 + 1/dz^2)), the smallest over the rows; the solid's viscosity counts
/// from its first row on.
[[nodiscard]] double viscosity_limit(double viscosity, const SolidInput& solid, const Grid& grid);

}  // namespace softwall::fluid
