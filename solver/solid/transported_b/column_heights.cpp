#include "solver/solid/transported_b/column_heights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softwall::solid {

ColumnHeights::ColumnHeights(const Grid& grid, grid::Halo& halo)
    : grid_(grid),
      halo_(halo),
      heights_(single_row(grid), kGhost),
      faces_(static_cast<std::size_t>(grid.ny) + 1),
      bases_(static_cast<std::size_t>(grid.nx) + 2 * kGhost),
      fluid_(bases_.size()),
      row_height_(Real(grid.dy[std::min(grid.ny_fluid, grid.ny - 1)])) {
  for (int j = 0; j <= grid.ny; ++j)
    faces_[static_cast<std::size_t>(j)] = Real(grid.y_face[j] - grid.y_face[grid.ny_fluid]);
  for (auto& strip : strips_) strip.resize(static_cast<std::size_t>(grid.nx));
  for (auto* slope : {&slope_x_, &slope_z_}) slope->resize(static_cast<std::size_t>(grid.nx));
}

void ColumnHeights::find(const grid::Field& fraction, int first_row) {
  const auto phi = fraction.view();
  const auto height = heights_.view();
  double *const base = bases_.data() + kGhost, *const fluid = fluid_.data() + kGhost;
  const auto face = [this](int j) { return grid_.y_face[j] - grid_.y_face[grid_.ny_fluid]; };
  const int i0 = -kGhost, i1 = grid_.nx + kGhost;
  for (int k = -kGhost; k < grid_.nz + kGhost; ++k) {
    std::fill(base + i0, base + i1, face(first_row));
    std::fill(fluid + i0, fluid + i1, 0.0);
    for (int j = first_row; j < grid_.ny; ++j) {
      const double dy = grid_.dy[j], top = face(j + 1);
#pragma omp simd
      for (int i = i0; i < i1; ++i) {
        const double here = phi(i, j, k), sum = fluid[i] + (1 - here) * dy;
        base[i] = here > 0 ? base[i] : top;
        fluid[i] = here > 0 ? sum : 0;
      }
    }
    for (int i = i0; i < i1; ++i) height(i, 0, k) = Real(base[i] + fluid[i]);
  }
}

void ColumnHeights::put(grid::Field& fraction, int first_row) {
  halo_.fill({&heights_}, {0, 1});
  const auto phi = fraction.view();
  const int nx = grid_.nx;
  for (int k = 0; k < grid_.nz; ++k) {
    find_slopes(k, faces_[static_cast<std::size_t>(first_row)]);
    const Range surface = find_strips(k);
    for (int j = first_row; j < grid_.ny; ++j) {
      const Real bottom = faces_[static_cast<std::size_t>(j)], top = faces_[static_cast<std::size_t>(j) + 1];
      Real* const row = &phi(0, j, k);
      if (surface.highest > bottom && surface.lowest < top) {
        put_crossed_row(j, row);
      } else {
        std::fill(row, row + nx, Real(surface.highest <= bottom ? 1 : 0));
      }
    }
  }
}

/// Half the rise of the surface from the column before to the one behind, or less where a strip would
/// otherwise lie beyond the wall or below the rows in use, and what is beyond would be lost.
void ColumnHeights::find_slopes(int k, Real lowest) {
  const auto height = std::as_const(heights_).view();
  const Real wall = faces_.back(), farthest = offset_of(kStrips - 1);
#pragma omp simd
  for (int i = 0; i < grid_.nx; ++i) {
    const Real here = height(i, 0, k), in_x = (height(i + 1, 0, k) - height(i - 1, 0, k)) / 2,
               in_z = (height(i, 0, k + 1) - height(i, 0, k - 1)) / 2;
    const Real below = here - lowest, above = wall - here, least = below < above ? below : above,
               room = least > 0 ? least : 0, reach = farthest * (std::abs(in_x) + std::abs(in_z)),
               part = reach > room ? room / reach : 1;
    slope_x_[static_cast<std::size_t>(i)] = part * in_x;
    slope_z_[static_cast<std::size_t>(i)] = part * in_z;
  }
}

/// Strips lie alike on both sides of the column's center, so that slopes do not change their mean.
ColumnHeights::Range ColumnHeights::find_strips(int k) {
  const auto height = std::as_const(heights_).view();
  Real lowest = std::numeric_limits<Real>::max(), highest = std::numeric_limits<Real>::lowest();
  for (int c = 0; c < kStrips; ++c) {
    for (int a = 0; a < kStrips; ++a) {
      const Real in_x = offset_of(a), in_z = offset_of(c);
      const Real *const slope_x = slope_x_.data(), *const slope_z = slope_z_.data();
      Real* const out = strips_[static_cast<std::size_t>(c * kStrips + a)].data();
#pragma omp simd reduction(min : lowest) reduction(max : highest)
      for (int i = 0; i < grid_.nx; ++i) {
        const Real here = height(i, 0, k) + in_x * slope_x[i] + in_z * slope_z[i];
        lowest = here < lowest ? here : lowest;
        highest = here > highest ? here : highest;
        out[i] = here;
      }
    }
  }
  return {lowest, highest};
}

/// phi: of cell (0, j, k).
void ColumnHeights::put_crossed_row(int j, Real* phi) const {
  const Real bottom = faces_[static_cast<std::size_t>(j)], top = faces_[static_cast<std::size_t>(j) + 1];
  const Real inverse = 1 / (top - bottom);
  std::fill(phi, phi + grid_.nx, Real(0));
  for (const auto& strip : strips_) {
    const Real* const height = strip.data();
#pragma omp simd
    for (int i = 0; i < grid_.nx; ++i) {
      const Real share = height[i] <= bottom ? 1 : (top - height[i]) * inverse;
      phi[i] += (share > 0 ? share : 0) / (kStrips * kStrips);
    }
  }
}

double ColumnHeights::flatness(int i, int k) const {
  const auto height = heights_.view();
  const double in_x = (height(i + 1, 0, k) - height(i - 1, 0, k)) / (2 * row_height_),
               in_z = (height(i, 0, k + 1) - height(i, 0, k - 1)) / (2 * row_height_);
  return 1 / (1 + in_x * in_x + in_z * in_z);
}

}  // namespace softwall::solid
