#pragma once

#include <vector>

#include "solver/run_directory/block_statistics.hpp"

/// Convergence check: in a stationary mean the total shear stress is the straight line u_tau_w^2 - P y,
/// through fluid and solid, because P acts over the whole height.
namespace softwall::analysis {

/// viscous_stress - uv + elastic_stress on the faces [U_b^2]; elastic_stress may be absent in a rigid
/// channel. Empty when another of these profiles is missing. `weights`: see block_means.hpp.
[[nodiscard]] std::vector<double> total_stress(const BlockStatistics& statistics,
                                               const std::vector<double>& weights);

/// rms over the height of total stress - (u_tau_w^2 - P y), divided by u_tau_w^2; NaN when total_stress is
/// empty.
[[nodiscard]] double stress_balance_residual(const BlockStatistics& statistics,
                                             const std::vector<double>& weights);

}  // namespace softwall::analysis
