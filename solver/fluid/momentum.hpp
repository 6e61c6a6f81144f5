#pragma once

#include "solver/grid/field.hpp"

/// Right-hand side of the momentum equation on the staggered grid, without pressure and elastic force:
///   R_i = -d(u_i u_j)/dx_j + d/dx_j [ mu (du_i/dx_j + du_j/dx_i) ],      mu = nu (1 + (ratio - 1) phi)
/// second-order central differences in conservative form. Momentum fluxes meet where both velocities average
/// to: u u on centers, u v on the edge between low-x and low-y faces, and so on. What is carried is the plain
/// mean of two neighbours; what carries it is the flow through the side of the control volume, weighted with
/// heights around a y face. So convection is skew-symmetric and keeps the discrete kinetic energy on
/// stretched grids too (Verstappen & Veldman, J. Comput. Phys. 187, 2003).
namespace softwall::fluid {

using grid::Grid;
using grid::Real;
using grid::View;

/// What the momentum kernels read: velocity, solid fraction (only if kVariable), spacings, viscosities.
struct MomentumInput {
  View<const Real> u, v, w, phi;
  const Real *inv_dy, *inv_dy_face, *upper_share;  ///< row arrays, index j
  Real inv_dx, inv_dz;
  Real nu;      ///< fluid viscosity 1/Re
  Real excess;  ///< nu (ratio - 1): what phi = 1 adds
};

/// Viscosity at the center of cell (i, j, k).
template <bool kVariable>
inline Real viscosity(const MomentumInput& m, int i, int j, int k) {
  if constexpr (!kVariable) return m.nu;
  return m.nu + m.excess * m.phi(i, j, k);
}
/// Volume-weighted on the xy edge (low-x, low-y) of the cell.
template <bool kVariable>
inline Real viscosity_xy(const MomentumInput& m, int i, int j, int k) {
  if constexpr (!kVariable) return m.nu;
  const Real up = m.upper_share[j] / 2, low = (1 - m.upper_share[j]) / 2;
  return m.nu + m.excess * (up * (m.phi(i, j, k) + m.phi(i - 1, j, k)) +
                            low * (m.phi(i, j - 1, k) + m.phi(i - 1, j - 1, k)));
}
template <bool kVariable>
inline Real viscosity_xz(const MomentumInput& m, int i, int j, int k) {
  if constexpr (!kVariable) return m.nu;
  return m.nu +
         m.excess * (m.phi(i, j, k) + m.phi(i - 1, j, k) + m.phi(i, j, k - 1) + m.phi(i - 1, j, k - 1)) / 4;
}
template <bool kVariable>
inline Real viscosity_yz(const MomentumInput& m, int i, int j, int k) {
  if constexpr (!kVariable) return m.nu;
  const Real up = m.upper_share[j] / 2, low = (1 - m.upper_share[j]) / 2;
  return m.nu + m.excess * (up * (m.phi(i, j, k) + m.phi(i, j, k - 1)) +
                            low * (m.phi(i, j - 1, k) + m.phi(i, j - 1, k - 1)));
}

/// Viscous stress minus momentum flux, tau_ab - u_a u_b, named flux_ab: component a carried by component b.
template <bool kVariable>
inline Real flux_xx(const MomentumInput& m, int i, int j, int k) {
  const Real mean = (m.u(i, j, k) + m.u(i + 1, j, k)) / 2;
  return 2 * viscosity<kVariable>(m, i, j, k) * (m.u(i + 1, j, k) - m.u(i, j, k)) * m.inv_dx - mean * mean;
}
template <bool kVariable>
inline Real flux_yy(const MomentumInput& m, int i, int j, int k) {
  const Real mean = (m.v(i, j, k) + m.v(i, j + 1, k)) / 2;
  return 2 * viscosity<kVariable>(m, i, j, k) * (m.v(i, j + 1, k) - m.v(i, j, k)) * m.inv_dy[j] - mean * mean;
}
template <bool kVariable>
inline Real flux_zz(const MomentumInput& m, int i, int j, int k) {
  const Real mean = (m.w(i, j, k) + m.w(i, j, k + 1)) / 2;
  return 2 * viscosity<kVariable>(m, i, j, k) * (m.w(i, j, k + 1) - m.w(i, j, k)) * m.inv_dz - mean * mean;
}
/// Mean of a component over the height of the control volume around y face j: the flow through its side.
inline Real around_y_face(const MomentumInput& m, const View<const Real>& q, int i, int j, int k) {
  return q(i, j - 1, k) + m.upper_share[j] * (q(i, j, k) - q(i, j - 1, k));
}
template <bool kVariable>
inline Real stress_xy(const MomentumInput& m, int i, int j, int k) {
  const Real shear =
      (m.u(i, j, k) - m.u(i, j - 1, k)) * m.inv_dy_face[j] + (m.v(i, j, k) - m.v(i - 1, j, k)) * m.inv_dx;
  return viscosity_xy<kVariable>(m, i, j, k) * shear;
}
template <bool kVariable>
inline Real stress_yz(const MomentumInput& m, int i, int j, int k) {
  const Real shear =
      (m.v(i, j, k) - m.v(i, j, k - 1)) * m.inv_dz + (m.w(i, j, k) - m.w(i, j - 1, k)) * m.inv_dy_face[j];
  return viscosity_yz<kVariable>(m, i, j, k) * shear;
}
template <bool kVariable>
inline Real flux_xy(const MomentumInput& m, int i, int j, int k) {
  const Real u_mean = (m.u(i, j, k) + m.u(i, j - 1, k)) / 2, v_mean = (m.v(i, j, k) + m.v(i - 1, j, k)) / 2;
  return stress_xy<kVariable>(m, i, j, k) - u_mean * v_mean;
}
template <bool kVariable>
inline Real flux_yx(const MomentumInput& m, int i, int j, int k) {
  const Real v_mean = (m.v(i, j, k) + m.v(i - 1, j, k)) / 2;
  return stress_xy<kVariable>(m, i, j, k) - v_mean * around_y_face(m, m.u, i, j, k);
}
template <bool kVariable>
inline Real flux_xz(const MomentumInput& m, int i, int j, int k) {
  const Real u_mean = (m.u(i, j, k) + m.u(i, j, k - 1)) / 2, w_mean = (m.w(i, j, k) + m.w(i - 1, j, k)) / 2;
  const Real shear =
      (m.u(i, j, k) - m.u(i, j, k - 1)) * m.inv_dz + (m.w(i, j, k) - m.w(i - 1, j, k)) * m.inv_dx;
  return viscosity_xz<kVariable>(m, i, j, k) * shear - u_mean * w_mean;
}
template <bool kVariable>
inline Real flux_zy(const MomentumInput& m, int i, int j, int k) {
  const Real v_mean = (m.v(i, j, k) + m.v(i, j, k - 1)) / 2, w_mean = (m.w(i, j, k) + m.w(i, j - 1, k)) / 2;
  return stress_yz<kVariable>(m, i, j, k) - w_mean * v_mean;
}
template <bool kVariable>
inline Real flux_yz(const MomentumInput& m, int i, int j, int k) {
  const Real v_mean = (m.v(i, j, k) + m.v(i, j, k - 1)) / 2;
  return stress_yz<kVariable>(m, i, j, k) - v_mean * around_y_face(m, m.w, i, j, k);
}

/// R of the three components, on the low faces of cell (i, j, k).
template <bool kVariable>
inline Real momentum_x(const MomentumInput& m, int i, int j, int k) {
  return (flux_xx<kVariable>(m, i, j, k) - flux_xx<kVariable>(m, i - 1, j, k)) * m.inv_dx +
         (flux_xy<kVariable>(m, i, j + 1, k) - flux_xy<kVariable>(m, i, j, k)) * m.inv_dy[j] +
         (flux_xz<kVariable>(m, i, j, k + 1) - flux_xz<kVariable>(m, i, j, k)) * m.inv_dz;
}
template <bool kVariable>
inline Real momentum_y(const MomentumInput& m, int i, int j, int k) {
  return (flux_yx<kVariable>(m, i + 1, j, k) - flux_yx<kVariable>(m, i, j, k)) * m.inv_dx +
         (flux_yy<kVariable>(m, i, j, k) - flux_yy<kVariable>(m, i, j - 1, k)) * m.inv_dy_face[j] +
         (flux_yz<kVariable>(m, i, j, k + 1) - flux_yz<kVariable>(m, i, j, k)) * m.inv_dz;
}
template <bool kVariable>
inline Real momentum_z(const MomentumInput& m, int i, int j, int k) {
  return (flux_xz<kVariable>(m, i + 1, j, k) - flux_xz<kVariable>(m, i, j, k)) * m.inv_dx +
         (flux_zy<kVariable>(m, i, j + 1, k) - flux_zy<kVariable>(m, i, j, k)) * m.inv_dy[j] +
         (flux_zz<kVariable>(m, i, j, k) - flux_zz<kVariable>(m, i, j, k - 1)) * m.inv_dz;
}

}  // namespace softwall::fluid
