#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/material.hpp"

/// How what belongs to the solid goes on below it, column by column: y is whole on every rank, and the solid
/// is the top of every column.
namespace softwall::solid {

/// Walks down the columns of each plane of the box from row `top_row` and copies a row of the components from
/// above wherever fraction(i, j, k) is below `threshold`, or was anywhere above; then calls `row_done` with
/// that row as a box.
template <std::size_t kCount, class FractionAt, class RowDone>
void extend_down(const std::array<grid::Field*, kCount>& components, const FractionAt& fraction,
                 Real threshold, int top_row, const grid::Box& box, const RowDone& row_done) {
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

template <std::size_t kCount, class FractionAt>
void extend_down(const std::array<grid::Field*, kCount>& components, const FractionAt& fraction,
                 Real threshold, int top_row, const grid::Box& box) {
  extend_down(components, fraction, threshold, top_row, box, [](const grid::Box&) {});
}

}  // namespace softwall::solid
