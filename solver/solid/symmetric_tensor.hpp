#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

/// A symmetric 3 x 3 tensor as six numbers, and what is asked of it.
namespace softwall::solid {

struct SymmetricTensor {
  double xx = 1, yy = 1, zz = 1, xy = 0, xz = 0, yz = 0;

  [[nodiscard]] double trace() const { return xx + yy + zz; }
  [[nodiscard]] double determinant() const {
    return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  }
  [[nodiscard]] SymmetricTensor shifted(double s) const { return {xx + s, yy + s, zz + s, xy, xz, yz}; }
  /// Sylvester's criterion: all leading minors positive.
  [[nodiscard]] bool positive_definite() const {
    return (xx > 0) & (xx * yy - xy * xy > 0) & (determinant() > 0);
  }
};

/// Smallest eigenvalue by the trigonometric solution of the characteristic cubic (Smith, Comm. ACM 4, 1961).
[[nodiscard]] inline double min_eigenvalue(const SymmetricTensor& t) {
  const double mean = t.trace() / 3;
  const SymmetricTensor d = t.shifted(-mean);
  const double p2 =
      (d.xx * d.xx + d.yy * d.yy + d.zz * d.zz + 2 * (d.xy * d.xy + d.xz * d.xz + d.yz * d.yz)) / 6;
  if (!(p2 > 0)) return mean;
  const double p = std::sqrt(p2);
  const double angle = std::acos(std::clamp(d.determinant() / (2 * p2 * p), -1.0, 1.0)) / 3;
  return mean + 2 * p * std::cos(angle + 2 * std::numbers::pi / 3);
}

}  // namespace softwall::solid
