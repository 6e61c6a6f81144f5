#pragma once

#include <span>

#include "solver/fluid/predictor.hpp"
#include "solver/parallel/decomposition.hpp"

/// The uniform pressure gradient that holds the flow rate of the fluid-filled region. It adds the same amount
/// to u in every cell, so that sum((1 - phi) u dV) / sum((1 - phi) dV) is the bulk velocity. That amount,
/// U_b, divided by the duration of the substep is the driving gradient P; over a step the amounts add up to P
/// dt. Uniform, so the divergence of the velocity does not change.
namespace softwall::fluid {

/// The velocity that a projection is about to make, u = u* - duration d psi/dx.
struct PendingVelocity {
  const grid::Field& predicted;      ///< u*
  const grid::Field& psi;            ///< ghost cells at low x filled
  double duration;                   ///< 2 alpha dt, h / U_b
  std::span<const double> row_sums;  ///< of u* over this rank's cells of row j, U_b
};

/// Returns the velocity that must be added to the fluid everywhere for its bulk velocity to be as given.
[[nodiscard]] double flow_rate_correction(const PendingVelocity& velocity, const SolidInput& solid,
                                          double bulk_velocity, const Grid& grid,
                                          const parallel::Decomposition& decomposition);

/// Adds what is missing to a velocity that stands, and returns it.
[[nodiscard]] double hold_flow_rate(grid::VectorField& velocity, const SolidInput& solid,
                                    double bulk_velocity, const Grid& grid,
                                    const parallel::Decomposition& decomposition);

}  // namespace softwall::fluid
