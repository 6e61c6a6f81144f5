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

namespace {

/// What flows through the low faces of a row of control volumes, in each direction.
template <WenoWeights kWeights, class PointVelocity>
struct FluxesOfRows {
  View<const Real> q;
  const PointVelocity& velocity;

  void x(int j, int k, int end, Real* out) const {
#pragma omp simd
    for (int i = 0; i < end; ++i) out[i] = upwind_flux<kWeights>(&q(i, j, k), 1, velocity.x(i, j, k));
  }
  void y(int j, int k, int end, Real* out) const {
#pragma omp simd
    for (int i = 0; i < end; ++i)
      out[i] = upwind_flux<kWeights>(&q(i, j, k), q.stride_y, velocity.y(i, j, k));
  }
  void z(int j, int k, int end, Real* out) const {
#pragma omp simd
    for (int i = 0; i < end; ++i)
      out[i] = upwind_flux<kWeights>(&q(i, j, k), q.stride_z, velocity.z(i, j, k));
  }
};

}  // namespace

template <WenoWeights kWeights, class PointVelocity>
void Advection::sweep(View<const Real> q, const PointVelocity& velocity, int first_row, View<Real> rate) {
  const Grid& g = grid_;
  const FluxesOfRows<kWeights, PointVelocity> fluxes{q, velocity};
  const Real inv_dx = Real(1 / g.dx), inv_dz = Real(1 / g.dz);
  const Real* inv_height = PointVelocity::kOnYFace ? g.inv_dy_face.data() : g.inv_dy.data();
  const int j0 = PointVelocity::kOnYFace ? std::max(first_row, 1) : first_row;
  const int nx = g.nx;
  Real* const x = flux_x_.data();
  Real *low_y = flux_y_[0].data(), *high_y = flux_y_[1].data(), *low_z = flux_z_[0].data(),
       *high_z = flux_z_[1].data();

  const bool flat = g.nz_global == 1;  // what enters through one side in z leaves through the other
  const auto in_plane = [=](Real* plane, int j) { return plane + std::ptrdiff_t(j) * nx; };
  for (int j = j0; j < g.ny && !flat; ++j) fluxes.z(j, 0, nx, in_plane(low_z, j));
  for (int k = 0; k < g.nz; ++k) {
    // Around a y face the lowest volume begins at the first center, where v need not vanish as it does on the
    // wall.
    if (PointVelocity::kOnYFace && first_row == 0) {
      fluxes.y(j0, k, nx, low_y);
    } else {
      std::fill_n(low_y, nx, Real(0));
    }
    for (int j = j0; j < g.ny; ++j) {
      fluxes.x(j, k, nx + 1, x);
      // A center's top face may be the wall, where v = 0; a y-face quantity's top neighbour is then the wall
      // row.
      fluxes.y(j + 1, k, nx, high_y);
      Real *const z0 = in_plane(low_z, j), *const z1 = in_plane(high_z, j);
      if (!flat) fluxes.z(j, k + 1, nx, z1);
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
