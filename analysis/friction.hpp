#pragma once

/// Friction velocities of the two walls from the momentum balance over 0 < y < interface_y.
namespace softwall::analysis {

struct FrictionInput {
  double reynolds = 0.0;
  double driving_gradient = 0.0;   ///< P [rho U_b^2 / h]
  double wall_shear_bottom = 0.0;  ///< nu dU/dy at y = 0 [U_b^2]
  double interface_y = 2.0;        ///< height over which P acts on the fluid [h]
};

struct Friction {
  double u_tau_w = 0.0;  ///< bottom wall: u_tau_w^2 = nu dU/dy (the paper, eq:friction_velocity)
  double u_tau = 0.0;    ///< upper wall: u_tau^2 = P interface_y - u_tau_w^2, so 2 P - u_tau_w^2 here
  double re_tau_w = 0.0, re_tau = 0.0;  ///< u_tau Re
};

/// A negative square (a mean too short or not stationary) gives NaN.
[[nodiscard]] Friction friction(const FrictionInput& input);

}  // namespace softwall::analysis
