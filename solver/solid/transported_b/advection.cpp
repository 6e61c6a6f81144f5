#include "solver/solid/transported_b/advection.hpp"

#include <algorithm>
#include <utility>

namespace softwall::solid {

Advection::Advection(const Grid& grid, WenoWeights weights)
    : grid_(grid), weights_(weights), flux_x_(static_cast<std::size_t>(grid.nx) + 1) {
  for (auto& row : flux_y_) row.resize(static_cast<std::size_t>(grid.nx));
  for (auto& plane : flux_z_)
    plane.resize(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
}

template <WenoWeights kWeights, class PointVelocity>
void Advection::sweep(View<const Real> q, const PointVelocity& velocity, int first_row, View<Real> rate) {
  const Grid& g = grid_;
  const Real inv_dx = Real(1 / g.dx), inv_dz = Real(1 / g.dz);
  const Real* inv_height = PointVelocity::kOnYFace ? g.inv_dy_face.data() : g.inv_dy.data();
  const int j0 = PointVelocity::kOnYFace ? std::max(first_row, 1) : first_row;
  const int nx = g.nx;
  Real* const x = flux_x_.data();
  Real *low_y = flux_y_[0].data(), *high_y = flux_y_[1].data(), *low_z = flux_z_[0].data(),
       *high_z = flux_z_[1].data();

  const bool flat = g.nz_global == 1;  // what enters through one side in z leaves through the other
  const auto z_row = [&](int j, int k, Real* out) {
    if (flat) return;
#pragma omp simd
    for (int i = 0; i < nx; ++i) out[i] = upwind_flux<kWeights>(&q(i, j, k), q.stride_z, velocity.z(i, j, k));
  };
  for (int j = j0; j < g.ny; ++j) z_row(j, 0, low_z + std::ptrdiff_t(j) * nx);
  for (int k = 0; k < g.nz; ++k) {
    // Around a y face the lowest volume begins at the first center, where v need not vanish as it does on the
    // wall.
    const bool from_wall_cell = PointVelocity::kOnYFace && first_row == 0;
#pragma omp simd
    for (int i = 0; i < nx; ++i) {
      low_y[i] =
          from_wall_cell ? upwind_flux<kWeights>(&q(i, j0, k), q.stride_y, velocity.y(i, j0, k)) : Real(0);
    }
    for (int j = j0; j < g.ny; ++j) {
#pragma omp simd
      for (int i = 0; i <= nx; ++i) x[i] = upwind_flux<kWeights>(&q(i, j, k), 1, velocity.x(i, j, k));
        // A center's top face may be the wall, where v = 0; a y-face quantity's top neighbour is then the
        // wall row.
#pragma omp simd
      for (int i = 0; i < nx; ++i) {
        high_y[i] = upwind_flux<kWeights>(&q(i, j + 1, k), q.stride_y, velocity.y(i, j + 1, k));
      }
      Real* const z0 = low_z + std::ptrdiff_t(j) * nx;
      Real* const z1 = high_z + std::ptrdiff_t(j) * nx;
      z_row(j, k + 1, z1);
      Real* const out = &rate(0, j, k);
      const Real inv_dy = inv_height[j];
#pragma omp simd
      for (int i = 0; i < nx; ++i) {
        out[i] = -((x[i + 1] - x[i]) * inv_dx + (high_y[i] - low_y[i]) * inv_dy + (z1[i] - z0[i]) * inv_dz);
      }
      std::swap(low_y, high_y);
    }
    std::swap(low_z, high_z);
  }
}

template <class PointVelocity>
void Advection::rate_of(const grid::Field& q, const PointVelocity& velocity, int first_row,
                        grid::Field& rate) {
  if (weights_ == WenoWeights::kJiangShu) {
    sweep<WenoWeights::kJiangShu>(q.view(), velocity, first_row, rate.view());
  } else {
    sweep<WenoWeights::kZ>(q.view(), velocity, first_row, rate.view());
  }
}

template void Advection::rate_of(const grid::Field&, const CenterVelocity&, int, grid::Field&);
template void Advection::rate_of(const grid::Field&, const EdgeXyVelocity&, int, grid::Field&);
template void Advection::rate_of(const grid::Field&, const EdgeXzVelocity&, int, grid::Field&);
template void Advection::rate_of(const grid::Field&, const EdgeYzVelocity&, int, grid::Field&);

}  // namespace softwall::solid
