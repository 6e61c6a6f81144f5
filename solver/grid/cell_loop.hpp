#pragma once

#include "solver/grid/grid.hpp"

/// Where kernels run: today SIMD loops on one core of each rank. A kernel is a function of (i, j, k).
namespace softwall::grid {

/// Half-open box of cells.
struct Box {
  int i0 = 0, i1 = 0, j0 = 0, j1 = 0, k0 = 0, k1 = 0;
};

/// All cells of this rank.
[[nodiscard]] inline Box all_cells(const Grid& g) { return {0, g.nx, 0, g.ny, 0, g.nz}; }

/// All cells of this rank in rows j0 <= j < j1.
[[nodiscard]] inline Box rows(const Grid& g, int j0, int j1) { return {0, g.nx, j0, j1, 0, g.nz}; }

/// Runs `kernel(i, j, k)` for every cell of the box. No cell may depend on what another one writes.
template <class Kernel>
void for_each_cell(const Box& box, const Kernel& kernel) {
  for (int k = box.k0; k < box.k1; ++k) {
    for (int j = box.j0; j < box.j1; ++j) {
#pragma omp simd
      for (int i = box.i0; i < box.i1; ++i) kernel(i, j, k);
    }
  }
}

/// Sum of `term(i, j, k)` over the box, row by row, always in the same order.
template <class Term>
[[nodiscard]] double sum_cells(const Box& box, const Term& term) {
  double total = 0.0;
  for (int k = box.k0; k < box.k1; ++k) {
    for (int j = box.j0; j < box.j1; ++j) {
      double row = 0.0;
#pragma omp simd reduction(+ : row)
      for (int i = box.i0; i < box.i1; ++i) row += term(i, j, k);
      total += row;
    }
  }
  return total;
}

/// Largest `value(i, j, k)` over the box; `lowest` when the box is empty.
template <class Value>
[[nodiscard]] double max_cells(const Box& box, double lowest, const Value& value) {
  double top = lowest;
  for (int k = box.k0; k < box.k1; ++k) {
    for (int j = box.j0; j < box.j1; ++j) {
#pragma omp simd reduction(max : top)
      for (int i = box.i0; i < box.i1; ++i) {
        const double here = value(i, j, k);
        top = here > top ? here : top;
      }
    }
  }
  return top;
}

}  // namespace softwall::grid
