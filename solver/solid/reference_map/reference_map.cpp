#include "solver/solid/reference_map/reference_map.hpp"

#include <algorithm>
#include <utility>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"

namespace softwall::solid::reference_map {

namespace {

constexpr int kGhost = Material::kGhost;

/// Rows of d that are kept below the band: as far as transport reads.
int lowest_kept_row(int first_row) { return std::max(0, first_row - kGhost); }

/// Planes of rates that are found before the first of them is used: as far as transport reads.
constexpr int kPlanes = kGhost + 1;

class NoFollower final : public PlaneFollower {
 public:
  void plane_is_ready(int) override {}
};

}  // namespace

ReferenceMap::ReferenceMap(const SolidSpec& spec, const Grid& grid,
                           const parallel::Decomposition& decomposition, grid::Halo& halo)
    : grid_(grid),
      weights_(spec.weno),
      decomposition_(decomposition),
      halo_(halo),
      speeds_(grid),
      recent_(grid::some_planes(grid, kPlanes)),
      before_(grid, 0),
      volume_error_(grid, 1),
      is_neo_hookean_(law_of<Real>(spec).is_neo_hookean()),
      damage_(law_of<Real>(spec), grid),
      mending_(grid, kPlanes),
      strain_(grid),
      own_heights_(grid, 1),
      wide_heights_(grid, 2),
      extrapolation_(grid),
      isochoric_extension_(grid),
      fractions_(grid),
      share_(kFluidAtFlatInterface, grid) {}

int ReferenceMap::lowest_row(const Material& m) {
  own_heights_.find(m.displacement.y, m.surface_at_rest);
  const double lowest = own_heights_.lowest();
  int row = 0;
  while (row + 1 < grid_.ny && grid_.y_face[row + 1] <= lowest) ++row;
  return row;
}

void ReferenceMap::transport(Material& m, const grid::VectorField& velocity, const Stage& stage, double dt,
                             int first_row, PlaneFollower* follower) {
  advance(m, velocity, stage, dt, first_row);
  extend_below_surface(m, first_row);
  derive(m, first_row);
  if (follower) limited_cells_ += find_strain(m, first_row, *follower);
}

PlaneOfRates ReferenceMap::recent_rates(int k) {
  const auto plane = [k](grid::Field& f) { return View<Real>{&f(0, 0, k % kPlanes), f.view().stride_y, 0}; };
  return {plane(recent_.x), plane(recent_.y), plane(recent_.z)};
}

/// A plane is updated as soon as no other one's rates read it: in one sweep, while it is in the cache.
void ReferenceMap::advance(Material& m, const grid::VectorField& velocity, const Stage& stage, double dt,
                           int first_row) {
  speeds_.set(dt);
  speeds_.restore_volume(dt, m.surface_at_rest, mean_height_ - m.surface_at_rest);
  const VolumeRelaxation relaxation(speeds_, volume_error_);
  for (int k = 0; k < grid_.nz + kGhost; ++k) {
    if (k < grid_.nz) {
      const RowsOfAPlane rows{k, first_row};
      find_rates(m.displacement, velocity, relaxation, grid_, weights_, rows, recent_rates(k));
      mending_.find(damage_, m.displacement, rows, 2 * stage.alpha * dt);
    }
    if (k >= kGhost) {
      const RowsOfAPlane rows{k - kGhost, first_row};
      update(m.displacement, stage, dt, rows);
      mending_.add(damage_, rows, m.displacement);
    }
  }
}

/// The rates of the plane become those of the substep before.
void ReferenceMap::update(grid::VectorField& d, const Stage& stage, double dt, const RowsOfAPlane& rows) {
  const Real by_now = Real(stage.beta * dt), by_before = Real(stage.gamma * dt);
  const auto step = [&](grid::Field& component, View<Real> rate, grid::Field& rate_before, int j0) {
    const auto q = component.view(), before = rate_before.view();
    grid::for_each_cell({0, grid_.nx, j0, grid_.ny, rows.k, rows.k + 1}, [=](int i, int j, int k) {
      const Real now = rate(i, j, k);
      q(i, j, k) += by_now * now + by_before * before(i, j, k);
      before(i, j, k) = now;
    });
  };
  const PlaneOfRates now = recent_rates(rows.k);
  step(d.x, now.x, before_.x, rows.j0);
  step(d.y, now.y, before_.y, std::max(rows.j0, 1));
  step(d.z, now.z, before_.z, rows.j0);
}

void ReferenceMap::extend_below_surface(Material& m, int first_row) {
  auto& d = m.displacement;
  const int lowest = lowest_kept_row(first_row);
  for (const auto side : {grid::Side::kLowX, grid::Side::kLowZ})
    halo_.fill_side(side, {&d.y}, {lowest, grid_.ny + 1});
  own_heights_.find(d.y, m.surface_at_rest);
  extrapolation_.extend(own_heights_, lowest, d);
  fill_ghosts(d, first_row);
  isochoric_extension_.apply(own_heights_, lowest, d);
  // Where the layer is two rows thin, those beyond the wall mirror rows that were extended.
  fill_beyond_walls(d, first_row);
  halo_.fill({&d.y}, rows_with_ghosts(first_row));
}

void ReferenceMap::make_consistent(Material& m, int first_row, PlaneFollower& follower) {
  fill_ghosts(m.displacement, first_row);
  derive(m, first_row);
  find_strain(m, first_row, follower);
}

grid::RowSpan ReferenceMap::rows_with_ghosts(int first_row) const {
  return {first_row > kGhost ? first_row - kGhost : -kGhost, grid_.ny + kGhost};
}

void ReferenceMap::fill_ghosts(grid::VectorField& d, int first_row) {
  fill_beyond_walls(d, first_row);
  halo_.fill({&d.x, &d.y, &d.z}, rows_with_ghosts(first_row));
}

/// The surface and phi. Reads the displacement and its ghost cells.
void ReferenceMap::derive(Material& m, int first_row) {
  wide_heights_.find(m.displacement.y, m.surface_at_rest);
  mean_height_ =
      parallel::sum(decomposition_.all(), wide_heights_.sum()) / (double(grid_.nx_global) * grid_.nz_global);
  const double row_height = row_height_at(m.surface_at_rest);
  share_.follow([&](int i, int k) { return wide_heights_.flatness(i, k, row_height); });
  m.all_solid_from = fractions_.fill(wide_heights_, first_row, m.phi);
  continue_fraction(m, first_row);
}

double ReferenceMap::row_height_at(double y) const {
  int row = grid_.ny - 1;
  while (row > 0 && grid_.y_face[row] > y) --row;
  return grid_.dy[row];
}

/// Odd about a wall for the components along it; even for d_y, whose first derivative vanishes there with the
/// others' (volume).
void ReferenceMap::fill_beyond_walls(grid::VectorField& d, int first_row) const {
  const int ny = grid_.ny;
  const auto columns = grid::rows(grid_, 0, 1);
  const auto x = d.x.view(), y = d.y.view(), z = d.z.view();
  grid::for_each_cell(columns, [=](int i, int, int k) { y(i, ny, k) = 0; });
  for (int n = 1; n <= kGhost; ++n) {
    grid::for_each_cell(columns, [=](int i, int, int k) {
      x(i, ny - 1 + n, k) = -x(i, ny - n, k);
      z(i, ny - 1 + n, k) = -z(i, ny - n, k);
      if (n < kGhost) y(i, ny + n, k) = y(i, ny - n, k);
    });
    if (first_row > kGhost) continue;
    grid::for_each_cell(columns, [=](int i, int, int k) {
      x(i, -n, k) = -x(i, n - 1, k);
      z(i, -n, k) = -z(i, n - 1, k);
      y(i, -n, k) = y(i, n, k);
    });
  }
}

/// Copies phi of the row at a wall to the row beyond it.
void ReferenceMap::continue_fraction(Material& m, int first_row) const {
  const Grid& g = grid_;
  const auto phi = m.phi.view();
  const auto around = [&](int j) { return grid::Box{-1, g.nx + 1, j, j + 1, -1, g.nz + 1}; };
  const int top = g.ny - 1;
  grid::for_each_cell(around(g.ny), [=](int i, int j, int k) { phi(i, j, k) = phi(i, top, k); });
  if (first_row > 0) return;
  grid::for_each_cell(around(-1), [=](int i, int j, int k) { phi(i, j, k) = phi(i, 0, k); });
}

/// B. Returns the number of torn cells. The stress of a neo-Hookean solid reads no more of its neighbours
/// than the sweep finds. Any other needs all ghost cells of B, and so the whole of B, before its first plane.
std::int64_t ReferenceMap::find_strain(Material& m, int first_row, PlaneFollower& follower) {
  NoFollower nobody;
  const std::int64_t torn =
      strain_.run(strain_of(m.displacement, grid_), std::as_const(m.phi).view(), first_row,
                  {m.B.xx.view(), m.B.yy.view(), m.B.zz.view(), m.B.xy.view(), m.B.xz.view(), m.B.yz.view(),
                   volume_error_.view()},
                  damage_, is_neo_hookean_ ? follower : nobody);
  if (is_neo_hookean_) return torn;
  halo_.fill({&m.B.xx, &m.B.yy, &m.B.zz, &m.B.xy, &m.B.xz, &m.B.yz}, {first_row, grid_.ny + 1});
  for (int k = 0; k < grid_.nz; ++k) follower.plane_is_ready(k);
  return torn;
}

}  // namespace softwall::solid::reference_map
