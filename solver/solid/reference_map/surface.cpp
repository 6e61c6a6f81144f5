#include "solver/solid/reference_map/surface.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

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

constexpr int kStrips = 4;

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

Strip strip(int a, int c) {
  const auto offset = [](int n) { return (n + double(0.5)) / kStrips - double(0.5); };
  const auto side = [](int n) { return 2 * n < kStrips ? -1 : 1; };
  return {side(a), side(c), offset(a) * side(a), offset(c) * side(c)};
}

using StripHeights = std::array<std::vector<double>, std::size_t{kStrips} * kStrips>;

/// Heights over the strips of the columns -1 <= i <= nx of one line, stored from element 0 on.
void find_strips(const Heights& heights, int nx, int k, StripHeights& strips) {
  for (int c = 0; c < kStrips; ++c) {
    for (int a = 0; a < kStrips; ++a) {
      const Strip s = strip(a, c);
      const double *near = heights.row(k), *far = heights.row(k + s.to_z);
      double* const out = strips[static_cast<std::size_t>(c * kStrips + a)].data() + 1;
#pragma omp simd
      for (int i = -1; i <= nx; ++i) out[i] = s.height(near, far, i);
    }
  }
}

}  // namespace

Heights::Heights(const Grid& grid, int ghost)
    : grid_(grid),
      ghost_(ghost),
      stride_(grid.nx + 2 * ghost),
      values_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(grid.nz + 2 * ghost)) {}

void Heights::find(const grid::Field& displacement, double at_rest) {
  const auto d = displacement.view();
  const auto& y = grid_.y_face;
  const int i0 = -ghost_, i1 = grid_.nx + ghost_;
  for (int k = -ghost_; k < grid_.nz + ghost_; ++k) {
    double* const eta = values_.data() + offset(k);
    std::fill(eta + i0, eta + i1, kPending);
    int pending = i1 - i0;
    for (int j = grid_.ny - 1; j >= 0 && pending > 0; --j) {
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

void fill_fraction(const Heights& heights, const Grid& g, int j0, grid::Field& fraction) {
  const auto phi = fraction.view();
  StripHeights strips;
  for (auto& s : strips) s.resize(static_cast<std::size_t>(g.nx) + 2);
  for (int k = -1; k <= g.nz; ++k) {
    find_strips(heights, g.nx, k, strips);
    for (int j = j0; j < g.ny; ++j) {
      const double bottom = g.y_face[j], top = g.y_face[j + 1], inv_dy = 1 / g.dy[j];
      Real* const row = &phi(0, j, k);
      std::fill(row - 1, row + g.nx + 1, Real(0));
      for (const auto& s : strips) {
        const double* const height = s.data() + 1;
#pragma omp simd
        for (int i = -1; i <= g.nx; ++i) {
          const double share = height[i] <= bottom ? 1 : (top - height[i]) * inv_dy;
          row[i] += Real((share > 0 ? share : 0) / (kStrips * kStrips));
        }
      }
    }
  }
}

}  // namespace softwall::solid::reference_map
