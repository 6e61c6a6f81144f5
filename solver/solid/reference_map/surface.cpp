#include "solver/solid/reference_map/surface.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

#include "solver/grid/cell_loop.hpp"

namespace softwall::solid::reference_map {

namespace {

/// Not yet met; lower than any wall.
constexpr double kPending = -1e9;

/// One step down, from a row where the surface has not been met to the next: rests holds y - d_y.
struct Step {
  double y_above, y_here, at_rest;
  /// Height at which the line through (rest above, y_above) and (rest here, y_here) meets the surface.
  [[nodiscard]] double crossing(double rest_above, double rest_here) const {
    const double below = at_rest - rest_here, fall = rest_above - rest_here;
    return y_here + below / fall * (y_above - y_here);
  }
};

/// Height of the surface over strip (a, c) of column i, from the heights of the four columns around it.
struct Strip {
  int to_x, to_z;           ///< neighbours on its side
  double share_x, share_z;  ///< of the neighbours
  [[nodiscard]] double height(const double* near, const double* far, int i) const {
    const double here = near[i] + share_x * (near[i + to_x] - near[i]);
    const double there = far[i] + share_x * (far[i + to_x] - far[i]);
    return here + share_z * (there - here);
  }
};

Strip strip(int a, int c, int strips) {
  const auto offset = [=](int n) { return (n + double(0.5)) / strips - double(0.5); };
  const auto side = [=](int n) { return 2 * n < strips ? -1 : 1; };
  return {side(a), side(c), offset(a) * side(a), offset(c) * side(c)};
}

}  // namespace

Heights::Heights(const Grid& grid, int ghost)
    : grid_(grid),
      ghost_(ghost),
      stride_(grid.nx + 2 * ghost),
      values_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(grid.nz + 2 * ghost)) {}

/// Rows above the highest point of the surface, most of the layer, are only looked at, height by height, as
/// they lie in memory.
void Heights::find(const grid::Field& displacement, double at_rest) {
  const auto d = displacement.view();
  const auto& y = grid_.y_face;
  const int i0 = -ghost_, i1 = grid_.nx + ghost_, k0 = -ghost_, k1 = grid_.nz + ghost_;
  const auto least_rest = [&](int j) {
    constexpr double kLowest = -std::numeric_limits<double>::infinity();
    return y[j] - grid::max_cells({i0, i1, j, j + 1, k0, k1}, kLowest, d);
  };
  int highest = grid_.ny - 1;
  while (highest >= 0 && least_rest(highest) > at_rest) --highest;
  for (int k = k0; k < k1; ++k) {
    double* const eta = values_.data() + offset(k);
    std::fill(eta + i0, eta + i1, kPending);
    int pending = i1 - i0;
    for (int j = highest; j >= 0 && pending > 0; --j) {
      const Step step{y[j + 1], y[j], at_rest};
      pending = 0;
#pragma omp simd reduction(+ : pending)
      for (int i = i0; i < i1; ++i) {
        const double above = step.y_above - d(i, j + 1, k), here = step.y_here - d(i, j, k);
        const bool waiting = eta[i] == kPending, met = here <= at_rest;
        const double height = step.crossing(met ? above : here + 1, here);
        eta[i] = waiting && met ? height : eta[i];
        pending += waiting && !met ? 1 : 0;
      }
    }
    std::replace(eta + i0, eta + i1, kPending, y[0]);
  }
}

double Heights::lowest() const {
  double lowest = grid_.y_face[grid_.ny];
  for (int k = 0; k < grid_.nz; ++k) lowest = std::min(lowest, *std::min_element(row(k), row(k) + grid_.nx));
  return lowest;
}

double Heights::sum() const {
  double sum = 0;
  for (int k = 0; k < grid_.nz; ++k) sum = std::accumulate(row(k), row(k) + grid_.nx, sum);
  return sum;
}

CellFractions::CellFractions(const Grid& grid) : grid_(grid) {
  for (auto& s : strips_) s.resize(static_cast<std::size_t>(grid.nx) + 2);
}

CellFractions::Range CellFractions::find_strips(const Heights& heights, int k) {
  double lowest = grid_.y_face[grid_.ny], highest = grid_.y_face[0];
  for (int c = 0; c < kStrips; ++c) {
    for (int a = 0; a < kStrips; ++a) {
      const Strip s = strip(a, c, kStrips);
      const double *near = heights.row(k), *far = heights.row(k + s.to_z);
      double* const out = strips_[static_cast<std::size_t>(c * kStrips + a)].data() + 1;
#pragma omp simd reduction(min : lowest) reduction(max : highest)
      for (int i = -1; i <= grid_.nx; ++i) {
        const double height = s.height(near, far, i);
        lowest = height < lowest ? height : lowest;
        highest = height > highest ? height : highest;
        out[i] = height;
      }
    }
  }
  return {lowest, highest};
}

/// phi: of cell (0, j, k).
void CellFractions::fill_crossed_row(double bottom, double top, Real* phi) const {
  const int nx = grid_.nx;
  const double inverse = 1 / (top - bottom);
  std::fill(phi - 1, phi + nx + 1, Real(0));
  for (const auto& s : strips_) {
    const double* const height = s.data() + 1;
#pragma omp simd
    for (int i = -1; i <= nx; ++i) {
      const double share = height[i] <= bottom ? 1 : (top - height[i]) * inverse;
      phi[i] += Real((share > 0 ? share : 0) / (kStrips * kStrips));
    }
  }
}

int CellFractions::fill(const Heights& heights, int j0, grid::Field& fraction) {
  const Grid& g = grid_;
  const auto phi = fraction.view();
  int all_solid_from = j0;
  for (int k = -1; k <= g.nz; ++k) {
    const Range surface = find_strips(heights, k);
    while (all_solid_from < g.ny && surface.highest > g.y_face[all_solid_from]) ++all_solid_from;
    for (int j = j0; j < g.ny; ++j) {
      const double bottom = g.y_face[j], top = g.y_face[j + 1];
      Real* const row = &phi(0, j, k);
      if (surface.highest > bottom && surface.lowest < top) {
        fill_crossed_row(bottom, top, row);
      } else {
        std::fill(row - 1, row + g.nx + 1, Real(surface.highest <= bottom ? 1 : 0));
      }
    }
  }
  return all_solid_from;
}

}  // namespace softwall::solid::reference_map
