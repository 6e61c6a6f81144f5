#pragma once

#include "solver/grid/field.hpp"

/// Right-hand side of the momentum equation on the staggered grid, without pressure and the forces of the
/// solid:
///   R_i = -d(u_i u_j)/dx_j + d/dx_j [ nu (du_i/dx_j + du_j/dx_i) ]
/// second-order central differences in conservative form. Momentum fluxes meet where both velocities average
/// to: u u on centers, u v on the edge between low-x and low-y faces, and so on. What is carried is the plain
/// mean of two neighbours; what carries it is the flow through the side of the control volume, weighted with
/// heights around a y face. So convection is skew-symmetric and keeps the discrete kinetic energy on
/// stretched grids too (Verstappen & Veldman, J. Comput. Phys. 187, 2003).
namespace softwall::fluid {

using grid::Grid;
using grid::Real;
using grid::View;

/// What the momentum kernels read: velocity, spacings, viscosity.
struct MomentumInput {
  View<const Real> u, v, w;
  const Real *inv_dy, *inv_dy_face, *upper_share;  ///< row arrays, index j
  Real inv_dx, inv_dz;
  Real nu;  ///< the fluid's, 1/Re; what the solid's adds is a force of its own (solid/excess_viscosity.hpp)
};
[[nodiscard]] inline MomentumInput momentum_input(const grid::VectorField& velocity, const Grid& g,
                                                  double nu) {
  return {.u = velocity.x.view(),
          .v = velocity.y.view(),
          .w = velocity.z.view(),
          .inv_dy = g.inv_dy.data(),
          .inv_dy_face = g.inv_dy_face.data(),
          .upper_share = g.upper_share.data(),
          .inv_dx = Real(1 / g.dx),
          .inv_dz = Real(1 / g.dz),
          .nu = Real(nu)};
}

/// Viscous stress minus momentum flux, tau_ab - u_a u_b, named flux_ab: component a carried by component b.
inline Real flux_xx(const MomentumInput& m, int i, int j, int k) {
  const Real mean = (m.u(i, j, k) + m.u(i + 1, j, k)) / 2;
  return 2 * m.nu * (m.u(i + 1, j, k) - m.u(i, j, k)) * m.inv_dx - mean * mean;
}
inline Real flux_yy(const MomentumInput& m, int i, int j, int k) {
  const Real mean = (m.v(i, j, k) + m.v(i, j + 1, k)) / 2;
  return 2 * m.nu * (m.v(i, j + 1, k) - m.v(i, j, k)) * m.inv_dy[j] - mean * mean;
}
inline Real flux_zz(const MomentumInput& m, int i, int j, int k) {
  const Real mean = (m.w(i, j, k) + m.w(i, j, k + 1)) / 2;
  return 2 * m.nu * (m.w(i, j, k + 1) - m.w(i, j, k)) * m.inv_dz - mean * mean;
}
/// Mean of a component over the height of the control volume around y face j: the flow through its side.
inline Real around_y_face(const MomentumInput& m, const View<const Real>& q, int i, int j, int k) {
  return q(i, j - 1, k) + m.upper_share[j] * (q(i, j, k) - q(i, j - 1, k));
}
inline Real stress_xy(const MomentumInput& m, int i, int j, int k) {
  const Real shear =
      (m.u(i, j, k) - m.u(i, j - 1, k)) * m.inv_dy_face[j] + (m.v(i, j, k) - m.v(i - 1, j, k)) * m.inv_dx;
  return m.nu * shear;
}
inline Real stress_yz(const MomentumInput& m, int i, int j, int k) {
  const Real shear =
      (m.v(i, j, k) - m.v(i, j, k - 1)) * m.inv_dz + (m.w(i, j, k) - m.w(i, j - 1, k)) * m.inv_dy_face[j];
  return m.nu * shear;
}
inline Real stress_xz(const MomentumInput& m, int i, int j, int k) {
  const Real shear =
      (m.u(i, j, k) - m.u(i, j, k - 1)) * m.inv_dz + (m.w(i, j, k) - m.w(i - 1, j, k)) * m.inv_dx;
  return m.nu * shear;
}
inline Real flux_xy(const MomentumInput& m, int i, int j, int k) {
  const Real u_mean = (m.u(i, j, k) + m.u(i, j - 1, k)) / 2, v_mean = (m.v(i, j, k) + m.v(i - 1, j, k)) / 2;
  return stress_xy(m, i, j, k) - u_mean * v_mean;
}
inline Real flux_yx(const MomentumInput& m, int i, int j, int k) {
  const Real v_mean = (m.v(i, j, k) + m.v(i - 1, j, k)) / 2;
  return stress_xy(m, i, j, k) - v_mean * around_y_face(m, m.u, i, j, k);
}
inline Real flux_xz(const MomentumInput& m, int i, int j, int k) {
  const Real u_mean = (m.u(i, j, k) + m.u(i, j, k - 1)) / 2, w_mean = (m.w(i, j, k) + m.w(i - 1, j, k)) / 2;
  return stress_xz(m, i, j, k) - u_mean * w_mean;
}
inline Real flux_zy(const MomentumInput& m, int i, int j, int k) {
  const Real v_mean = (m.v(i, j, k) + m.v(i, j, k - 1)) / 2, w_mean = (m.w(i, j, k) + m.w(i, j - 1, k)) / 2;
  return stress_yz(m, i, j, k) - w_mean * v_mean;
}
inline Real flux_yz(const MomentumInput& m, int i, int j, int k) {
  const Real v_mean = (m.v(i, j, k) + m.v(i, j, k - 1)) / 2;
  return stress_yz(m, i, j, k) - v_mean * around_y_face(m, m.w, i, j, k);
}

}  // namespace softwall::fluid
