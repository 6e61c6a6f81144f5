#include "solver/time/closed_box/disc.hpp"

#include <algorithm>
#include <cmath>

#include "solver/grid/cell_loop.hpp"

namespace softwall::time {

namespace {

struct Interval {
  double low = 0, high = 0;
};

double overlap(const Interval& a, const Interval& b) {
  return std::max(0.0, std::min(a.high, b.high) - std::max(a.low, b.low));
}

/// Length of a horizontal line at height y within the disc and an interval of x.
double chord(const DiscSpec& disc, double y, const Interval& x) {
  const double half2 = disc.radius * disc.radius - (y - disc.y) * (y - disc.y);
  if (half2 <= 0) return 0;
  const double half = std::sqrt(half2), slot = std::min(half, disc.slot_width / 2);
  const Interval whole{std::max(x.low, disc.x - half), std::min(x.high, disc.x + half)};
  if (whole.high <= whole.low) return 0;
  const bool above_slot = y >= disc.y - disc.radius + disc.slot_depth;
  return whole.high - whole.low - (above_slot ? 0 : overlap(whole, {disc.x - slot, disc.x + slot}));
}

}  // namespace

double disc_fraction(const DiscSpec& disc, double x_low, double y_low, double dx, double dy) {
  constexpr int kChords = 64;
  double length = 0;
  for (int n = 0; n < kChords; ++n) {
    length += chord(disc, y_low + (n + 0.5) * dy / kChords, {x_low, x_low + dx});
  }
  return length / (kChords * dx);
}

solid::Material disc_at_rest(const DiscSpec& disc, const grid::Grid& g) {
  solid::Material m(g);
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        m.phi(i, j, k) = disc_fraction(disc, (g.x_begin + i) * g.dx, g.y_face[j], g.dx, g.dy[j]);
      }
    }
  }
  for (grid::Field* normal : {&m.B.xx, &m.B.yy, &m.B.zz}) {
    const auto q = normal->view();
    grid::for_each_cell(grid::all_cells(g), [=](int i, int j, int k) { q(i, j, k) = 1; });
  }
  return m;
}

}  // namespace softwall::time
