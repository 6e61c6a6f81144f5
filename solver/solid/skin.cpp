#include "solver/solid/skin.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solver/solid/fraction.hpp"
#include "solver/solid/limiter.hpp"

namespace softwall::solid {

namespace {

/// Walks down the columns of each plane and copies a row of the components from above where the fraction has
/// fallen below the threshold; then calls `row_done` with that row as a box.
template <std::size_t kCount, class FractionAt, class RowDone>
void extend(const std::array<grid::Field*, kCount>& components, const FractionAt& fraction, Real threshold,
            int top_row, const grid::Box& box, const RowDone& row_done) {
  constexpr int kTogether = 256;       // columns side by side
  std::array<Real, kTogether> lowest;  // fraction met in each column so far
  for (int k = box.k0; k < box.k1; ++k) {
    for (int i0 = box.i0; i0 < box.i1; i0 += kTogether) {
      const int i1 = std::min(i0 + kTogether, box.i1);
      lowest.fill(1);
      for (int j = top_row; j >= box.j0; --j) {
#pragma omp simd
        for (int i = i0; i < i1; ++i) {
          Real& low = lowest[static_cast<std::size_t>(i - i0)];
          const Real here = fraction(i, j, k);
          low = here < low ? here : low;
        }
        for (grid::Field* component : components) {
          const auto b = component->view();
#pragma omp simd
          for (int i = i0; i < i1; ++i) {
            const Real own = b(i, j, k), above = b(i, j + 1, k);
            b(i, j, k) = lowest[static_cast<std::size_t>(i - i0)] < threshold ? above : own;
          }
        }
        row_done(grid::Box{i0, i1, j, j + 1, k, k + 1});
      }
    }
  }
}

}  // namespace

void extend_shear(Material& material, Real threshold, const Grid& g, const grid::Box& box) {
  const Fraction phi{std::as_const(material.phi).view(), g.upper_share.data()};
  auto& B = material.B;
  const auto nothing = [](const grid::Box&) {};
  const auto on_xy = [=](int i, int j, int k) { return phi.edge_xy(i, j, k); };
  const auto on_xz = [=](int i, int j, int k) { return phi.edge_xz(i, j, k); };
  const auto on_yz = [=](int i, int j, int k) { return phi.edge_yz(i, j, k); };
  extend(std::array{&B.xy}, on_xy, threshold, g.ny - 1, box, nothing);
  extend(std::array{&B.xz}, on_xz, threshold, g.ny - 2, box, nothing);
  extend(std::array{&B.yz}, on_yz, threshold, g.ny - 1, box, nothing);
}

std::int64_t extend_normal(Material& material, Real threshold, double floor, const Grid& g,
                           const grid::Box& box) {
  const Fraction phi{std::as_const(material.phi).view(), g.upper_share.data()};
  auto& B = material.B;
  const auto center = [=](int i, int j, int k) { return phi.center(i, j, k); };
  grid::Box top = box;  // the row at the wall has nothing above it
  top.j0 = g.ny - 1;
  std::int64_t limited = keep_positive_definite(B, floor, top);
  extend(std::array{&B.xx, &B.yy, &B.zz}, center, threshold, g.ny - 2, box,
         [&](const grid::Box& row) { limited += keep_positive_definite(B, floor, row); });
  return limited;
}

}  // namespace softwall::solid
