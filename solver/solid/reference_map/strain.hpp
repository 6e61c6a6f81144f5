#pragma once

#include "solver/grid/field.hpp"
#include "solver/solid/symmetric_tensor.hpp"

/// Deformation from the displacement d. The reference map xi = x - d has the gradient A = I - grad(d), the
/// deformation gradient is F = A^-1, and B = F F^T. With C the cofactors of A^T, so that F = C / det A,
///   B = (det A)^-2 C C^T.
/// det A = 1 in the continuum. Of the discrete d it is not quite, least of all beside the surface, and a
/// false change of volume must make no stress: the tensor used is that of the volume-preserving part of F,
///   B = (det A)^(2/3) F F^T = (det A)^(-4/3) C C^T,  det B = 1,
/// which is positive definite by construction.
///
/// d lives where u does, so each gradient has a place of its own, as the velocity's: d_x/dx at centers,
/// d_x/dy and d_y/dx on xy edges, ... Each component of B is formed where it lives (normal ones at centers,
/// shear on edges), from its own gradients there and the means of the others.
namespace softwall::solid::reference_map {

using grid::Real;
using grid::View;

/// A smaller det A, which only a displacement torn apart by the grid has, is taken for this.
inline constexpr Real kLeastVolume = 0.1;

/// How much of its B a point keeps, the rest of which is the identity, so that it bears that much less
/// stress: all where det A is at least kSoundVolume, as it is wherever the grid resolves the map, nothing at
/// kLeastVolume. Points that are torn beyond recognition bore the largest stress of all: on 96 x (72 + 24) x
/// 96 cells, G = 0.25, it drove jets of 8 U_b out of single cells of a crest, which tore their neighbours,
/// and the step fell to a quarter.
inline constexpr Real kSoundVolume = 0.5;
[[gnu::always_inline]] inline Real kept_share(Real determinant) {
  const Real place = (determinant - kLeastVolume) / (kSoundVolume - kLeastVolume);
  const Real positive = place > 0 ? place : Real(0), x = positive < 1 ? positive : Real(1);
  return x * x * (3 - 2 * x);
}

/// A = I - grad(d) at one point; xy is -d(d_x)/dy.
struct MapGradient {
  Real xx, xy, xz, yx, yy, yz, zx, zy, zz;

  // Cofactors: row a of F is (a_x, a_y, a_z) / det A.
  [[gnu::always_inline, nodiscard]] Real f_xx() const { return yy * zz - yz * zy; }
  [[gnu::always_inline, nodiscard]] Real f_xy() const { return xz * zy - xy * zz; }
  [[gnu::always_inline, nodiscard]] Real f_xz() const { return xy * yz - xz * yy; }
  [[gnu::always_inline, nodiscard]] Real f_yx() const { return yz * zx - yx * zz; }
  [[gnu::always_inline, nodiscard]] Real f_yy() const { return xx * zz - xz * zx; }
  [[gnu::always_inline, nodiscard]] Real f_yz() const { return xz * yx - xx * yz; }
  [[gnu::always_inline, nodiscard]] Real f_zx() const { return yx * zy - yy * zx; }
  [[gnu::always_inline, nodiscard]] Real f_zy() const { return xy * zx - xx * zy; }
  [[gnu::always_inline, nodiscard]] Real f_zz() const { return xx * yy - xy * yx; }
  [[gnu::always_inline, nodiscard]] Real determinant() const {
    return xx * f_xx() + xy * f_yx() + xz * f_zx();
  }

  [[gnu::always_inline, nodiscard]] Real square_x() const {
    return f_xx() * f_xx() + f_xy() * f_xy() + f_xz() * f_xz();
  }
  [[gnu::always_inline, nodiscard]] Real square_y() const {
    return f_yx() * f_yx() + f_yy() * f_yy() + f_yz() * f_yz();
  }
  [[gnu::always_inline, nodiscard]] Real square_z() const {
    return f_zx() * f_zx() + f_zy() * f_zy() + f_zz() * f_zz();
  }
  [[gnu::always_inline, nodiscard]] Real product_xy() const {
    return f_xx() * f_yx() + f_xy() * f_yy() + f_xz() * f_yz();
  }
  [[gnu::always_inline, nodiscard]] Real product_xz() const {
    return f_xx() * f_zx() + f_xy() * f_zy() + f_xz() * f_zz();
  }
  [[gnu::always_inline, nodiscard]] Real product_yz() const {
    return f_yx() * f_zx() + f_yy() * f_zy() + f_yz() * f_zz();
  }
};

/// J^(-4/3), J = det A. With e = 1 - J r^3, J^(-4/3) = r^4 (1 - e)^(-4/3) for any r: r is a Pade approximant
/// of J^(-1/3), the power of 1 - e a series as far as e^6, so that round-off is all that is wrong for
/// 0.3 < J < 4. Exactly 1 for 1. Beyond, r is too small, never too large: e stays between 0 and 1, and what
/// is found is positive and falls. Without branches, with one division and short chains of dependent
/// operations, for the compiler to vectorize and the processor to overlap.
[[gnu::always_inline]] inline Real volume_factor(Real determinant) {
  constexpr auto ratio = [](int numerator, int denominator) { return Real(numerator) / Real(denominator); };
  const Real J = determinant < kLeastVolume ? kLeastVolume : determinant;
  const Real r = (63 + J * (252 + J * 90)) / (20 + J * (210 + J * (168 + J * 7)));
  const Real r2 = r * r, e = 1 - J * r * r2, e2 = e * e;
  const Real power = 1 + ratio(4, 3) * e +
                     e2 * (ratio(14, 9) + ratio(140, 81) * e +
                           e2 * (ratio(455, 243) + ratio(1456, 729) * e + e2 * ratio(13832, 6561)));
  return r2 * r2 * power;
}

/// No component of B is larger: where a map is torn, its stress must not end the run.
inline constexpr Real kLargestStretch = 50;
[[gnu::always_inline]] inline Real bounded(Real component) {
  const Real less = component < kLargestStretch ? component : kLargestStretch;
  return less > -kLargestStretch ? less : -kLargestStretch;
}

/// B = factor C C^T + rest I at a point where det A is known.
struct FactorOfB {
  Real factor, rest;
  [[gnu::always_inline]] explicit FactorOfB(Real determinant)
      : factor(kept_share(determinant) * volume_factor(determinant)), rest(1 - kept_share(determinant)) {}
};

/// B at a point where A is known.
inline SymmetricTensor left_cauchy_green(const MapGradient& A) {
  const FactorOfB b(A.determinant());
  return {b.factor * A.square_x() + b.rest, b.factor * A.square_y() + b.rest,
          b.factor * A.square_z() + b.rest, b.factor * A.product_xy(),
          b.factor * A.product_xz(),        b.factor * A.product_yz()};
}

/// A displacement and its grid, and A at the centers. What lies on edges: strain_sweep.hpp.
struct Strain {
  View<const Real> x, y, z;  ///< displacement
  const Real *inv_dy, *inv_dy_face, *upper_share;
  Real inv_dx, inv_dz;

  [[gnu::always_inline]] MapGradient center(int i, int j, int k) const {
    // d/dy of a quantity at centers of rows, as the mean of its differences across both faces.
    const auto in_y = [=, this](const View<const Real>& q, int a, int c) {
      return ((q(a, j + 1, c) - q(a, j, c)) * inv_dy_face[j + 1] +
              (q(a, j, c) - q(a, j - 1, c)) * inv_dy_face[j]) /
             2;
    };
    const auto sum_x = [=, this](int b, int c) { return x(i, b, c) + x(i + 1, b, c); };
    const auto sum_y = [=, this](int a, int c) { return y(a, j, c) + y(a, j + 1, c); };
    const auto sum_z = [=, this](int a, int b) { return z(a, b, k) + z(a, b, k + 1); };
    return {
        1 - (x(i + 1, j, k) - x(i, j, k)) * inv_dx,        -(in_y(x, i, k) + in_y(x, i + 1, k)) / 2,
        -(sum_x(j, k + 1) - sum_x(j, k - 1)) / 4 * inv_dz, -(sum_y(i + 1, k) - sum_y(i - 1, k)) / 4 * inv_dx,
        1 - (y(i, j + 1, k) - y(i, j, k)) * inv_dy[j],     -(sum_y(i, k + 1) - sum_y(i, k - 1)) / 4 * inv_dz,
        -(sum_z(i + 1, j) - sum_z(i - 1, j)) / 4 * inv_dx, -(in_y(z, i, k) + in_y(z, i, k + 1)) / 2,
        1 - (z(i, j, k + 1) - z(i, j, k)) * inv_dz};
  }
};

/// The kernels' view of a displacement, whose ghost cells they read.
[[nodiscard]] inline Strain strain_of(const grid::VectorField& d, const grid::Grid& g) {
  return {.x = d.x.view(),
          .y = d.y.view(),
          .z = d.z.view(),
          .inv_dy = g.inv_dy.data(),
          .inv_dy_face = g.inv_dy_face.data(),
          .upper_share = g.upper_share.data(),
          .inv_dx = Real(1 / g.dx),
          .inv_dz = Real(1 / g.dz)};
}

}  // namespace softwall::solid::reference_map
