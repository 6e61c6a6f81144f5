#pragma once

/// The elastic law of the solid: what stress, energy and stiffness belong to a left Cauchy-Green tensor B.
/// The solid is neo-Hookean (paper eq:stress-s-he),
///   s_ij = G (B_ij - delta_ij),   W = G (tr B - 3) / 2,
/// so that each component of the stress follows from the same component of B, where that lives.
namespace softwall {

template <class Real>
struct ElasticLaw {
  Real G;  ///< modulus of transverse elasticity, rho U_b^2

  /// s_ii of B_ii.
  [[nodiscard]] constexpr Real normal_stress(Real B_ii) const { return G * (B_ii - 1); }
  /// s_ij of B_ij, i and j different.
  [[nodiscard]] constexpr Real shear_stress(Real B_ij) const { return G * B_ij; }
  /// Energy per volume of tr B.
  [[nodiscard]] constexpr Real energy(Real trace_of_B) const { return G / 2 * (trace_of_B - 3); }
  /// What a small displacement xi along n adds to the stress, over its gradient along n: rho times the square
  /// of the speed of shear waves along n, from B_nn = n.B.n.
  [[nodiscard]] constexpr Real stiffness(Real B_nn) const { return G * B_nn; }
};

}  // namespace softwall
