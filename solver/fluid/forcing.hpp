#pragma once

#include "solver/fluid/predictor.hpp"
#include "solver/parallel/decomposition.hpp"

/// The uniform pressure gradient that holds the flow rate of the fluid-filled region.
namespace softwall::fluid {

/// Adds the same amount to u in every cell so that sum((1 - phi) u dV) / sum((1 - phi) dV) = `bulk_velocity`,
/// and returns that amount, U_b. Divided by the duration of the substep it is the driving gradient P - of the
/// substep; over a step the amounts add up to P dt. Uniform, so the divergence of the velocity does not
/// change.
[[nodiscard]] double hold_flow_rate(grid::VectorField& velocity, const SolidInput& solid,
                                    double bulk_velocity, const Grid& grid,
                                    const parallel::Decomposition& decomposition);

}  // namespace softwall::fluid
