#include "solver/solid/reference_map/mending.hpp"

#include <algorithm>
#include <utility>

#include "solver/grid/cell_loop.hpp"

namespace softwall::solid::reference_map {

namespace {

/// Half the way to the mean of the six neighbours.
Real way_to_neighbours(const View<const Real>& q, int i, int j, int k) {
  return (q(i + 1, j, k) + q(i - 1, j, k) + q(i, j + 1, k) + q(i, j - 1, k) + q(i, j, k + 1) +
          q(i, j, k - 1)) /
             12 -
         q(i, j, k) / 2;
}

/// Number of cells, among n side by side, for which the condition holds.
template <class Condition>
int count(const Real* damage, int n, const Condition& condition) {
  int cells = 0;
#pragma omp simd reduction(+ : cells)
  for (int i = 0; i < n; ++i) cells += condition(damage[i]) ? 1 : 0;
  return cells;
}

}  // namespace

MendingRate::MendingRate(const ElasticLaw<Real>& law, const Grid& grid)
    : wave_x(Real(4 * law.stiffness(1) / (grid.dx * grid.dx))),
      wave_z(Real(4 * law.stiffness(1) / (grid.dz * grid.dz))),
      flow(Real(1 / grid.dx)) {}

Damage::Damage(const ElasticLaw<Real>& law, const Grid& grid)
    : nx_(grid.nx),
      ny_(grid.ny),
      rate_(law, grid),
      values_(grid, 1),
      rows_(static_cast<std::size_t>(grid.nz + 1) * static_cast<std::size_t>(grid.ny), 0) {}

int Damage::finish_row(int j, int k, const View<Real>& B_xx, const View<Real>& B_zz) {
  Real* const row = &values_.view()(0, j, k);
  const bool any = count(row - 1, nx_ + 1, [](Real damage) { return damage > 0; }) > 0;
  rows_[place(j, k)] = any ? 1 : 0;
  if (!any) return 0;
  const int torn = count(row, nx_, [](Real damage) { return damage == kTorn; });
  for (int i = -1; i < nx_; ++i) {
    if (row[i] > 0) row[i] = std::min(row[i], kFullDamage) * rate_.of(B_xx(i, j, k), B_zz(i, j, k), row[i]);
  }
  return torn;
}

Mending::Mending(const Grid& grid, int planes)
    : grid_(grid), planes_(planes), moves_(grid::some_planes(grid, planes)) {}

/// A point moves with the worse of the two cells beside it.
void Mending::find(const Damage& damage, const grid::VectorField& d, const RowsOfAPlane& rows,
                   double duration) {
  const auto x = d.x.view(), y = d.y.view(), z = d.z.view();
  const auto to_x = moves_.x.view(), to_y = moves_.y.view(), to_z = moves_.z.view();
  const auto rate = damage.view();
  const Real time = Real(duration);
  const auto share = [=](Real one, Real other) { return std::min(Real(1), time * std::max(one, other)); };
  const int k = rows.k, slot = k % planes_;
  for (int j = rows.j0; j < grid_.ny; ++j) {
    if (!damage.touches(j, k)) continue;
    const int below = j > rows.j0 ? j - 1 : j;
    grid::for_each_cell({0, grid_.nx, j, j + 1, k, k + 1}, [=](int i, int, int) {
      const Real here = rate(i, j, k);
      to_x(i, j, slot) = share(here, rate(i - 1, j, k)) * way_to_neighbours(x, i, j, k);
      to_y(i, j, slot) = share(here, rate(i, below, k)) * way_to_neighbours(y, i, j, k);
      to_z(i, j, slot) = share(here, rate(i, j, k - 1)) * way_to_neighbours(z, i, j, k);
    });
  }
}

/// d_y on the lower wall stays.
void Mending::add(const Damage& damage, const RowsOfAPlane& rows, grid::VectorField& d) const {
  const auto x = d.x.view(), y = d.y.view(), z = d.z.view();
  const auto from_x = moves_.x.view(), from_y = moves_.y.view(), from_z = moves_.z.view();
  const int k = rows.k, slot = k % planes_;
  for (int j = rows.j0; j < grid_.ny; ++j) {
    if (!damage.touches(j, k)) continue;
    const Real on_y = j > 0 ? 1 : 0;
    grid::for_each_cell({0, grid_.nx, j, j + 1, k, k + 1}, [=](int i, int, int) {
      x(i, j, k) += from_x(i, j, slot);
      y(i, j, k) += on_y * from_y(i, j, slot);
      z(i, j, k) += from_z(i, j, slot);
    });
  }
}

}  // namespace softwall::solid::reference_map
