#pragma once

#include "solver/case/cofactor_stiffness.hpp"
#include "solver/case/elastic_law.hpp"
#include "solver/case/step_limits.hpp"
#include "solver/solid/cofactors.hpp"
#include "solver/solid/fraction.hpp"
#include "solver/solid/interface_share.hpp"

/// The coefficient c of row_stiffness.hpp where two rows meet: functions of one place, which know nothing of
/// the order in which the systems are solved.
namespace softwall::solid {

/// c where rows meet, over the height between them.
struct RowCoefficients {
  Fraction phi;
  View<const Real> Byy;
  Cofactors C;
  ElasticLaw<Real> law;
  InterfaceShareView share;
  const Real *inv_dy, *inv_dy_face;
  Real elastic;     ///< (1 + s) (dt^2 / 4) G
  Real viscous;     ///< alpha dt times the viscosity of the fluid
  Real ratio;       ///< of the viscosities
  Real solid_edge;  ///< share of an edge from which on it lies in the solid
  int top;          ///< the edge on the upper wall
  int solid_from;   ///< edges of this row and of those above lie in the solid altogether

  template <class InPlane>
  [[nodiscard]] Real between(int j, const InPlane& q) const {
    const Real below = q(j - 1), upper_share = j == 0 ? 1 : j == top ? 0 : phi.upper_share[j];
    return below + upper_share * (q(j) - below);
  }
  [[nodiscard]] Real Byy_xy(int i, int j, int k) const {
    return between(j, [=, this](int row) { return Byy(i, row, k) + Byy(i - 1, row, k); }) / 2;
  }
  [[nodiscard]] Real Byy_yz(int i, int j, int k) const {
    return between(j, [=, this](int row) { return Byy(i, row, k) + Byy(i, row, k - 1); }) / 2;
  }
  /// Stiffness over G that waves between rows feel, of displacements along x on xy edges, along z on yz edges
  /// and along y at centers.
  template <bool kNeoHookean>
  [[nodiscard]] Real stretch_xy(int i, int j, int k) const {
    const Real B = Byy_xy(i, j, k);
    if constexpr (kNeoHookean) return B;
    return law.mean(
        B, between(j, [=, this](int row) { return (along_x(i, row, k) + along_x(i - 1, row, k)) / 2; }));
  }
  template <bool kNeoHookean>
  [[nodiscard]] Real stretch_yz(int i, int j, int k) const {
    const Real B = Byy_yz(i, j, k);
    if constexpr (kNeoHookean) return B;
    return law.mean(
        B, between(j, [=, this](int row) { return (along_z(i, row, k) + along_z(i, row, k - 1)) / 2; }));
  }
  template <bool kNeoHookean>
  [[nodiscard]] Real stretch_center(int i, int j, int k) const {
    if constexpr (kNeoHookean) return Byy(i, j, k);
    return law.mean(Byy(i, j, k), step_limits::implicit_along_y(C.xx(i, j, k), C.zz(i, j, k)));
  }
  /// Of displacements along x and z, at centers.
  [[nodiscard]] Real along_x(int i, int j, int k) const {
    return step_limits::implicit_in_plane(C.xx(i, j, k), C.xz_of_center(i, j, k));
  }
  [[nodiscard]] Real along_z(int i, int j, int k) const {
    return step_limits::implicit_in_plane(C.zz(i, j, k), C.xz_of_center(i, j, k));
  }
  template <bool kViscous>
  [[nodiscard]] Real in_solid(int j, Real stretch) const {
    Real c = elastic * stretch;
    if constexpr (kViscous) c += viscous * (ratio - 1);
    return c * inv_dy_face[j];
  }
  /// The same on an edge of which only the share `fraction` is solid, with a of interface_share.hpp.
  template <bool kViscous>
  [[nodiscard]] Real shared(int j, Real fraction, Real a, Real stretch) const {
    Real c = elastic * share_of_solid(fraction, a) * stretch;
    if constexpr (kViscous) {
      c += viscous * (factor_of_fluid(fraction, a) - 1);
      if (fraction >= solid_edge) c += viscous * of_solid_shear(fraction, a);
    }
    return c * inv_dy_face[j];
  }
  /// The coefficient with which the solid's shear, taken from the row above, acts on such an edge, over the
  /// height there.
  [[nodiscard]] Real shared_above(int j, Real fraction, Real a) const {
    return fraction < solid_edge ? viscous * of_solid_shear(fraction, a) * inv_dy_face[j + 1] : 0;
  }
  [[nodiscard]] Real of_solid_shear(Real fraction, Real a) const {
    return ratio * share_of_solid(fraction, a) - factor_of_fluid(fraction, a) * fraction;
  }
  template <bool kViscous>
  [[nodiscard]] Real center(int i, int j, int k, Real stretch) const {
    Real c = elastic * stretch;
    if constexpr (kViscous) c += 2 * viscous * (ratio - 1);
    return c * phi.center(i, j, k) * inv_dy[j];
  }
};

}  // namespace softwall::solid
