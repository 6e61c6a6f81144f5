#include "solver/pressure/tridiagonal.hpp"

#include <algorithm>

namespace softwall::pressure {

Tridiagonals::Tridiagonals(const grid::Grid& g, std::size_t most)
    : reduced_(most), ratio_(most * static_cast<std::size_t>(g.ny)) {
  for (int j = 0; j < g.ny; ++j) {
    lower_.push_back(j > 0 ? Real(g.inv_dy[j] * g.inv_dy_face[j]) : 0);
    upper_.push_back(j < g.ny - 1 ? Real(g.inv_dy[j] * g.inv_dy_face[j + 1]) : 0);
  }
}

/// Thomas algorithm, row by row for all systems at once. With f = upper / pivot and g = 1 - f,
///   pivot[j] = lower g[j-1] + kappa^2 + upper,   g[j] = (pivot - upper) / pivot,
/// free of cancellation: g stays exactly 0 where kappa^2 = 0, so that only the top pivot vanishes there.
void Tridiagonals::solve(Real* values, std::ptrdiff_t stride, Real kappa2_x, std::span<const Real> kappa2,
                         Real scale) {
  const auto systems = static_cast<std::ptrdiff_t>(kappa2.size());
  const auto rows = static_cast<std::ptrdiff_t>(lower_.size());
  const Real* const kappa2_z = kappa2.data();
  Real* const g = reduced_.data();
  std::fill(reduced_.begin(), reduced_.end(), Real(0));
  for (std::ptrdiff_t j = 0; j < rows; ++j) {
    const Real lower = lower_[static_cast<std::size_t>(j)], upper = upper_[static_cast<std::size_t>(j)];
    Real* const r = values + j * stride;
    const Real* const below = j > 0 ? r - stride : r;  // lower = 0 in the first row
    Real* const f = ratio_.data() + j * systems;
#pragma omp simd
    for (std::ptrdiff_t m = 0; m < systems; ++m) {
      const Real rest = lower * g[m] + (kappa2_x + kappa2_z[m]), pivot = rest + upper;
      const Real inverse = pivot > 0 ? 1 / pivot : 0;
      g[m] = rest * inverse;
      f[m] = upper * inverse;
      r[m] = (lower * below[m] - scale * r[m]) * inverse;
    }
  }
  for (std::ptrdiff_t j = rows - 2; j >= 0; --j) {
    Real* const r = values + j * stride;
    const Real *const above = r + stride, *const f = ratio_.data() + j * systems;
#pragma omp simd
    for (std::ptrdiff_t m = 0; m < systems; ++m) r[m] += f[m] * above[m];
  }
}

}  // namespace softwall::pressure
