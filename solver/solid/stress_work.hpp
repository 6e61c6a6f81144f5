#pragma once

#include <vector>

#include "solver/grid/field.hpp"

namespace softwall::solid {

/// The work that a stress s does on the strain of the flow, s_ij du_i/dx_j, of each row of cells: adds the
/// sum over this rank's columns to work[j], rows j0 <= j < j1. The stress is one that StressDivergence takes
/// (stress_divergence.hpp). What stands on the edges between two rows belongs to each by half. The sum of
/// this over all rows, times their heights, is minus the power of the force d s_ij / dx_j, to round-off,
/// where the stress vanishes below j0. Ghost cells of the velocity filled.
template <class Stress>
void add_stress_work(const Stress& stress, const grid::VectorField& velocity, const grid::Grid& g, int j0,
                     int j1, std::vector<double>& work) {
  const Stress s = stress;
  const auto u = velocity.x.view(), v = velocity.y.view(), w = velocity.z.view();
  const double inv_dx = 1 / g.dx, inv_dz = 1 / g.dz;
  const auto at_centers = [=, &g](int j, int k) {
    const double inv_dy = g.inv_dy[j];
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < g.nx; ++i) {
      sum +=
          s.xx(i, j, k) * (u(i + 1, j, k) - u(i, j, k)) * inv_dx +
          s.yy(i, j, k) * (v(i, j + 1, k) - v(i, j, k)) * inv_dy +
          s.zz(i, j, k) * (w(i, j, k + 1) - w(i, j, k)) * inv_dz +
          s.xz(i, j, k) * ((u(i, j, k) - u(i, j, k - 1)) * inv_dz + (w(i, j, k) - w(i - 1, j, k)) * inv_dx);
    }
    return sum;
  };
  const auto on_edges = [=, &g](int j, int k) {
    const double inv_dy = g.inv_dy_face[j];
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < g.nx; ++i) {
      sum +=
          s.xy(i, j, k) * ((u(i, j, k) - u(i, j - 1, k)) * inv_dy + (v(i, j, k) - v(i - 1, j, k)) * inv_dx) +
          s.yz(i, j, k) * ((w(i, j, k) - w(i, j - 1, k)) * inv_dy + (v(i, j, k) - v(i, j, k - 1)) * inv_dz);
    }
    return sum * g.dy_face[j];
  };
  for (int k = 0; k < g.nz; ++k) {
    for (int j = j0; j < j1; ++j) {
      double& of_row = work[static_cast<std::size_t>(j)];
      if constexpr (!Stress::kAcrossRowsOnly) of_row += at_centers(j, k);
      of_row += (on_edges(j, k) + on_edges(j + 1, k)) / 2 * g.inv_dy[j];
    }
  }
}

}  // namespace softwall::solid
