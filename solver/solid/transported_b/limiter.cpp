#include "solver/solid/transported_b/limiter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace softwall::solid {

SymmetricTensor tensor_at_center(const grid::TensorField& B, int i, int j, int k) {
  const auto xy = B.xy.view(), xz = B.xz.view(), yz = B.yz.view();
  return {B.xx(i, j, k),
          B.yy(i, j, k),
          B.zz(i, j, k),
          (xy(i, j, k) + xy(i + 1, j, k) + xy(i, j + 1, k) + xy(i + 1, j + 1, k)) / 4,
          (xz(i, j, k) + xz(i + 1, j, k) + xz(i, j, k + 1) + xz(i + 1, j, k + 1)) / 4,
          (yz(i, j, k) + yz(i, j + 1, k) + yz(i, j, k + 1) + yz(i, j + 1, k + 1)) / 4};
}

namespace {

/// More than what may be lost after the shift: by min_eigenvalue, half the digits of double where two
/// eigenvalues meet; by storing a component as Real, half an epsilon of |B_ii + shift| <= 4 (|trace| +
/// missing).
constexpr double kBeyond = std::max(1e-6, 16.0 * std::numeric_limits<grid::Real>::epsilon());

/// Cells of one row that fail Sylvester's criterion for B - floor I: a cheap test that vectorizes.
int failures_in_row(const grid::TensorField& B, double floor, const grid::Box& box, int j, int k) {
  int failures = 0;
#pragma omp simd reduction(+ : failures)
  for (int i = box.i0; i < box.i1; ++i) {
    failures += tensor_at_center(B, i, j, k).shifted(-floor).positive_definite() ? 0 : 1;
  }
  return failures;
}

}  // namespace

std::int64_t keep_positive_definite(grid::TensorField& B, double floor, const grid::Box& box) {
  std::int64_t touched = 0;
  for (int k = box.k0; k < box.k1; ++k) {
    for (int j = box.j0; j < box.j1; ++j) {
      if (failures_in_row(B, floor, box, j, k) == 0) continue;
      for (int i = box.i0; i < box.i1; ++i) {
        const SymmetricTensor here = tensor_at_center(std::as_const(B), i, j, k);
        const double missing = floor - min_eigenvalue(here);
        if (!(missing > 0)) continue;
        const double shift = missing + kBeyond * (std::abs(here.trace()) + missing);
        B.xx(i, j, k) += shift;
        B.yy(i, j, k) += shift;
        B.zz(i, j, k) += shift;
        ++touched;
      }
    }
  }
  return touched;
}

}  // namespace softwall::solid
