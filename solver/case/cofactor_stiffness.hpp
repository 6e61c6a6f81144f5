#pragma once

#include <algorithm>
#include <cmath>

#include "solver/case/step_limits.hpp"

/// What step_limits.hpp finds of B, for the part of a Mooney-Rivlin stress that acts through the cofactors C
/// of B (elastic_law.hpp). A wave of wave vector k and displacement along a unit vector a, which is normal to
/// k, has the stiffness |k|^2 a.C.a of this part.
namespace softwall::step_limits {

/// No eigenvalue of C is larger.
template <class Real>
[[nodiscard]] inline Real largest_row_sum(const Deformation<Real>& C) {
  const Real xy = std::abs(C.xy), xz = std::abs(C.xz), yz = std::abs(C.yz);
  return std::max(std::max(C.xx + xy + xz, C.yy + xy + yz), C.zz + xz + yz);
}

/// As `stiffness`: an upper bound of omega^2 / 4 of the stiffest two-cell wave.
template <class Real>
[[nodiscard]] inline Real cofactor_stiffness(const Deformation<Real>& C, const InverseSpacings<Real>& inv) {
  return (inv.dx * inv.dx + inv.dy * inv.dy + inv.dz * inv.dz) * largest_row_sum(C);
}

/// Stiffness between rows that is taken implicitly (solid/row_stiffness.hpp) of waves with displacement along
/// x, along z, and through y. The larger of the two in the plane serves the last, since a displacement in y
/// comes with one in the plane.
template <class Real>
[[nodiscard]] inline Real implicit_in_plane(Real C_tt, Real C_xz) {
  return C_tt + std::abs(C_xz);
}
template <class Real>
[[nodiscard]] inline Real implicit_along_y(Real C_xx, Real C_zz) {
  return std::max(C_xx, C_zz);
}

/// C_xy^2 / C_xx, which of a positive definite C is at most C_yy; that of a torn map may be anything.
template <class Real>
[[nodiscard]] inline Real coupling(Real C_xy, Real C_xx, Real C_yy) {
  const Real square = C_xy * C_xy, most = std::abs(C_yy);
  return square < most * C_xx ? square / C_xx : most;
}

/// As `stiffness_along_rows`: an upper bound of what the implicit part, (1 + s) times the above, leaves
/// explicit. With K^2 = k_x^2 + k_z^2 the stiffness is K^2 a.C.a + k_y^2 a.C.a. The first term is at most K^2
/// times the largest eigenvalue. In the second a_y k_y = -(a_x k_x + a_z k_z) is at most K, so that
///   2 C_xy a_x a_y k_y^2 <= s C_xx (a_x k_y)^2 + C_xy^2 K^2 / (s C_xx),
/// of which the implicit part has the first; the same holds of C_yz. Of C_yy (a_y k_y)^2 there remains what
/// exceeds implicit_along_y.
template <class Real>
[[nodiscard]] inline Real cofactor_stiffness_along_rows(const Deformation<Real>& C,
                                                        const InverseSpacings<Real>& inv) {
  const Real upright = std::max(Real(0), C.yy - implicit_along_y(C.xx, C.zz)),
             oblique = coupling(C.xy, C.xx, C.yy) + coupling(C.yz, C.zz, C.yy);
  return (inv.dx * inv.dx + inv.dz * inv.dz) *
         (largest_row_sum(C) + upright + oblique / Real(kSpareStiffness));
}

}  // namespace softwall::step_limits
