#include "solver/solid/transported_b/height_transport.hpp"

#include <algorithm>
#include <utility>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/weno.hpp"

namespace softwall::solid {

namespace {

/// Height of the part of a row, bottom < y < top, that lies above the surface.
Real part_above(Real surface, Real bottom, Real top) {
  const Real above = top - (surface > bottom ? surface : bottom);
  return above > 0 ? above : 0;
}

/// Of the heights around the low face of a column.
Real fifth_difference(const Real* at, std::ptrdiff_t stride) {
  return at[2 * stride] - at[-3 * stride] - 5 * (at[stride] - at[-2 * stride]) + 10 * (at[0] - at[-stride]);
}

}  // namespace

HeightTransport::HeightTransport(const Grid& grid, grid::Halo& halo, WenoWeights weights, double wave_speed)
    : grid_(grid),
      weights_(weights),
      wave_speed_(Real(wave_speed)),
      surface_(grid, halo),
      flow_x_(single_row(grid), 1),
      flow_z_(single_row(grid), 1),
      now_(single_row(grid), 0),
      before_(single_row(grid), 0) {
  for (auto* line : {&from_low_, &from_high_, &flow_high_, &speed_})
    line->resize(static_cast<std::size_t>(grid.nx) + 1);
}

void HeightTransport::advance(grid::Field& phi, const grid::VectorField& velocity, const Stage& stage,
                              double dt, int first_row) {
  find_rates(velocity, first_row);
  const Real by_now = Real(stage.beta * dt), by_before = Real(stage.gamma * dt);
  const auto height = surface_.view(), r = now_.view(), r_before = before_.view();
  grid::for_each_cell(grid::rows(grid_, 0, 1), [=](int i, int j, int k) {
    height(i, j, k) += by_now * r(i, j, k) + by_before * r_before(i, j, k);
  });
  std::swap(now_, before_);
  surface_.put(phi, first_row);
}

void HeightTransport::find_rates(const grid::VectorField& velocity, int first_row) {
  if (weights_ == WenoWeights::kJiangShu) {
    find_flows<WenoWeights::kJiangShu>(velocity, first_row);
  } else {
    find_flows<WenoWeights::kZ>(velocity, first_row);
  }
  const auto x = flow_x_.view(), z = flow_z_.view(), rate = now_.view();
  const Real inv_dx = Real(1 / grid_.dx), inv_dz = Real(1 / grid_.dz);
  grid::for_each_cell(grid::rows(grid_, 0, 1), [=](int i, int j, int k) {
    rate(i, j, k) = (x(i + 1, j, k) - x(i, j, k)) * inv_dx + (z(i, j, k + 1) - z(i, j, k)) * inv_dz;
  });
}

template <WenoWeights kWeights>
void HeightTransport::find_flows(const grid::VectorField& velocity, int first_row) {
  const auto height = surface_.view();
  const auto x = flow_x_.view(), z = flow_z_.view();
  const auto u = velocity.x.view(), w = velocity.z.view();
  const int nx = grid_.nx, nz = grid_.nz;
  for (int k = 0; k < nz; ++k)
    find_line_of_flows<kWeights>(u, &height(0, 0, k), 1, k, first_row, nx + 1, &x(0, 0, k));
  if (grid_.nz_global == 1) return;  // what enters through one side in z leaves through the other
  for (int k = 0; k <= nz; ++k)
    find_line_of_flows<kWeights>(w, &height(0, 0, k), height.stride_z, k, first_row, nx, &z(0, 0, k));
}

/// Flows through faces i < end of plane k, whose columns lie `stride` apart.
template <WenoWeights kWeights>
void HeightTransport::find_line_of_flows(const View<const Real>& velocity, const Real* heights,
                                         std::ptrdiff_t stride, int k, int first_row, int end, Real* flow) {
  Real *const low = from_low_.data(), *const high = from_high_.data(), *const flow_high = flow_high_.data(),
              *const speed = speed_.data();
#pragma omp simd
  for (int i = 0; i < end; ++i) {
    const Real* const at = heights + i;
    const Real m3 = at[-3 * stride], m2 = at[-2 * stride], m1 = at[-stride], p0 = at[0], p1 = at[stride],
               p2 = at[2 * stride];
    low[i] = weno5<kWeights>(m3, m2, m1, p0, p1);
    high[i] = weno5<kWeights>(p2, p1, p0, m1, m2);
  }
  std::fill(flow, flow + end, Real(0));
  std::fill(flow_high, flow_high + end, Real(0));
  std::fill(speed, speed + end, Real(0));
  const Real* const faces = surface_.faces().data();
  for (int j = first_row; j < grid_.ny; ++j) {
    const Real bottom = faces[j], top = faces[j + 1];
    const Real* const v = &velocity(0, j, k);
#pragma omp simd
    for (int i = 0; i < end; ++i) {
      const Real middle = (low[i] + high[i]) / 2;
      flow[i] += v[i] * part_above(low[i], bottom, top);
      flow_high[i] += v[i] * part_above(high[i], bottom, top);
      speed[i] += middle >= bottom && middle < top ? v[i] : 0;
    }
  }
  const Real smoothing = wave_speed_ / 60;
#pragma omp simd
  for (int i = 0; i < end; ++i)
    flow[i] = (speed[i] > 0 ? flow[i] : flow_high[i]) + smoothing * fifth_difference(heights + i, stride);
}

}  // namespace softwall::solid
