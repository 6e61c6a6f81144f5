#pragma once

#include "solver/case/case.hpp"

/// The elastic law of the solid: what stress, energy and stiffness belong to a left Cauchy-Green tensor B.
/// The solid is a Mooney-Rivlin material with two constants, c1 = (1 - m) G and c2 = m G:
///   W = c1 (tr B - 3) / 2 + c2 (tr C - 3) / 2,   s_ij = c1 (B_ij - delta_ij) - c2 (C_ij - delta_ij),
/// up to a pressure, where C are the cofactors of B. Since det B = 1, C is the inverse of B. With m = 0, the
/// default, the solid is neo-Hookean (paper eq:stress-s-he), and each component of the stress follows from
/// the same component of B alone, where that lives; what takes C is for every other m (solid/cofactors.hpp).
namespace softwall {

template <class Real>
struct ElasticLaw {
  Real G;                 ///< modulus of transverse elasticity, rho U_b^2
  Real mooney_share = 0;  ///< m = c2 / G

  [[nodiscard]] constexpr bool is_neo_hookean() const { return mooney_share == 0; }

  /// s_ii of B_ii.
  [[nodiscard]] constexpr Real normal_stress(Real B_ii) const { return G * (B_ii - 1); }
  /// s_ij of B_ij, i and j different.
  [[nodiscard]] constexpr Real shear_stress(Real B_ij) const { return G * B_ij; }
  /// Energy per volume of tr B.
  [[nodiscard]] constexpr Real energy(Real trace_of_B) const { return G / 2 * (trace_of_B - 3); }
  /// What a small displacement xi along n adds to the stress, over its gradient along n: rho times the square
  /// of the speed of shear waves along n, from B_nn = n.B.n.
  [[nodiscard]] constexpr Real stiffness(Real B_nn) const { return G * B_nn; }

  [[nodiscard]] constexpr Real normal_stress(Real B_ii, Real C_ii) const {
    return G * mean(B_ii - 1, 1 - C_ii);
  }
  [[nodiscard]] constexpr Real shear_stress(Real B_ij, Real C_ij) const { return G * mean(B_ij, -C_ij); }
  [[nodiscard]] constexpr Real energy(Real trace_of_B, Real trace_of_C) const {
    return G / 2 * (mean(trace_of_B, trace_of_C) - 3);
  }
  /// Stiffness over G from what the two parts have of it: of waves along n with their displacement along t,
  /// B_nn = n.B.n and C_tt = t.C.t.
  [[nodiscard]] constexpr Real mean(Real of_B, Real of_C) const {
    return of_B + mooney_share * (of_C - of_B);
  }
};

template <class Real>
[[nodiscard]] constexpr ElasticLaw<Real> law_of(const SolidSpec& solid) {
  return {Real(solid.G), Real(solid.mooney_share)};
}

}  // namespace softwall
