#include "solver/solid/transported_b/transported_b.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/transported_b/limiter.hpp"
#include "solver/solid/transported_b/skin.hpp"
#include "solver/solid/transported_b/stretching.hpp"
#include "solver/solid/transported_b/unit_determinant.hpp"

namespace softwall::solid {

namespace {

/// Under a surface that is a height, B below a threshold nearer to 1 is the row above's in more and more of
/// the cells that the surface passes through. What short waves had strained there is forgotten each time, and
/// the surface creeps until single columns stand out of it by the thickness of the layer (G = 0.5, t = 30).
constexpr double kHighestThresholdOfAHeight = 0.75;

/// A full cell has a fraction of 1 but for round-off, and would be taken for one at the surface.
constexpr double kHighestThreshold = 0.99;

Real threshold_of(const SolidSpec& spec) {
  const bool is_height = spec.interface == InterfaceTransport::kHeight;
  return Real(std::min(spec.threshold, is_height ? kHighestThresholdOfAHeight : kHighestThreshold));
}

/// rate += source, or = source.
template <class Source>
void add(grid::Field& rate, const grid::Box& box, const Source& source) {
  const auto r = rate.view();
  grid::for_each_cell(box, [=](int i, int j, int k) { r(i, j, k) += source(i, j, k); });
}
template <class Source>
void assign(grid::Field& rate, const grid::Box& box, const Source& source) {
  const auto r = rate.view();
  grid::for_each_cell(box, [=](int i, int j, int k) { r(i, j, k) = source(i, j, k); });
}

}  // namespace

TransportedB::TransportedB(const SolidSpec& spec, const Grid& grid,
                           const parallel::Decomposition& decomposition, grid::Halo& halo)
    : spec_(spec),
      threshold_(threshold_of(spec)),
      grid_(grid),
      halo_(halo),
      advection_(grid, spec.weno),
      now_{grid::Field(grid, 0), grid::TensorField(grid, 1)},
      before_{grid::Field(grid, 0), grid::TensorField(grid, 1)},
      share_(spec.interface == InterfaceTransport::kHeight ? kFluidAtFlatInterface : kMeanByVolume, grid),
      edges_(grid) {
  if (spec.interface == InterfaceTransport::kMthinc) fraction_.emplace(grid, halo);
  if (spec.interface == InterfaceTransport::kHeight)
    height_.emplace(grid, halo, spec.weno, std::sqrt(spec.G));
  if (spec.extension == Extension::kNormal) normal_.emplace(grid, decomposition, halo);
}

int TransportedB::lowest_row(const Material& material) {
  if (normal_) return 0;  // a body that moves about leaves dust anywhere
  const auto phi = material.phi.view();
  int lowest = 0;
  const auto holds_solid = [&](int j) {
    return grid::max_cells(grid::rows(grid_, j, j + 1), 0.0,
                           [=](int i, int row, int k) { return std::abs(phi(i, row, k)); }) > kDust;
  };
  while (lowest < grid_.ny && !holds_solid(lowest)) ++lowest;
  return lowest;
}

void TransportedB::transport(Material& material, const grid::VectorField& velocity, const Stage& stage,
                             double dt, int first_row, PlaneFollower* follower) {
  find_rates(material, velocity, first_row);
  if (fraction_) fraction_->advance(material.phi, velocity, stage, dt, first_row);
  if (height_) height_->advance(material.phi, velocity, stage, dt, first_row);
  update(material, stage, dt, first_row);
  if (height_) {
    restore_unit_determinant(material.B, grid_, halo_, first_row, restored_share(2 * stage.alpha * dt));
  }
  make_consistent(material, first_row);
  if (follower) show_planes(*follower);
}

void TransportedB::find_rates(const Material& m, const grid::VectorField& velocity, int first_row) {
  const Velocity base{velocity.x.view(), velocity.y.view(), velocity.z.view(), grid_.upper_share.data()};
  const int j0 = first_row, ny = grid_.ny;
  if (!fraction_ && !height_) advection_.rate_of(m.phi, CenterVelocity{base}, j0, now_.phi);
  advection_.rate_of(m.B.xx, CenterVelocity{base}, j0, now_.B.xx);
  advection_.rate_of(m.B.yy, CenterVelocity{base}, j0, now_.B.yy);
  advection_.rate_of(m.B.zz, CenterVelocity{base}, j0, now_.B.zz);
  advection_.rate_of(m.B.xy, EdgeXyVelocity{base}, j0, now_.B.xy);
  advection_.rate_of(m.B.xz, EdgeXzVelocity{base}, j0, now_.B.xz);
  advection_.rate_of(m.B.yz, EdgeYzVelocity{base}, j0, now_.B.yz);

  mark_solid_edges(m, threshold_, grid_, j0, edges_);
  const Stretching s = stretching_of(m.B, velocity, edges_.marks(), grid_);
  const auto centers = grid::rows(grid_, j0, ny), faces = grid::rows(grid_, std::max(j0, 1), ny);
  add(now_.B.xx, centers, [=](int i, int j, int k) { return s.rate_xx(i, j, k); });
  add(now_.B.yy, centers, [=](int i, int j, int k) { return s.rate_yy(i, j, k); });
  add(now_.B.zz, centers, [=](int i, int j, int k) { return s.rate_zz(i, j, k); });
  add(now_.B.xy, faces, [=](int i, int j, int k) { return s.rate_xy(i, j, k); });
  add(now_.B.xz, centers, [=](int i, int j, int k) { return s.rate_xz(i, j, k); });
  add(now_.B.yz, faces, [=](int i, int j, int k) { return s.rate_yz(i, j, k); });
  for (const int wall : {0, ny}) {
    if (wall == 0 && j0 > 0) continue;
    const auto row = grid::rows(grid_, wall, wall + 1);
    assign(now_.B.xy, row, [=](int i, int j, int k) { return s.rate_xy_wall(i, j, k); });
    assign(now_.B.yz, row, [=](int i, int j, int k) { return s.rate_yz_wall(i, j, k); });
  }
}

void TransportedB::update(Material& m, const Stage& stage, double dt, int first_row) {
  const Real by_now = Real(stage.beta * dt), by_before = Real(stage.gamma * dt);
  const auto step = [&](grid::Field& field, const grid::Field& now, const grid::Field& before, int top) {
    const auto q = field.view();
    const auto r = now.view(), r_before = before.view();
    grid::for_each_cell(grid::rows(grid_, first_row, top), [=](int i, int j, int k) {
      q(i, j, k) += by_now * r(i, j, k) + by_before * r_before(i, j, k);
    });
  };
  const int ny = grid_.ny;
  if (!fraction_ && !height_) step(m.phi, now_.phi, before_.phi, ny);
  step(m.B.xx, now_.B.xx, before_.B.xx, ny);
  step(m.B.yy, now_.B.yy, before_.B.yy, ny);
  step(m.B.zz, now_.B.zz, before_.B.zz, ny);
  step(m.B.xy, now_.B.xy, before_.B.xy, ny + 1);
  step(m.B.xz, now_.B.xz, before_.B.xz, ny);
  step(m.B.yz, now_.B.yz, before_.B.yz, ny + 1);
  std::swap(now_, before_);
}

void TransportedB::make_consistent(Material& m, int first_row, PlaneFollower& follower) {
  make_consistent(m, first_row);
  show_planes(follower);
}

void TransportedB::show_planes(PlaneFollower& follower) const {
  for (int k = 0; k < grid_.nz; ++k) follower.plane_is_ready(k);
}

void TransportedB::make_consistent(Material& m, int first_row) {
  if (normal_) {
    extend_body(m);
  } else {
    extend_layer(m, first_row);
  }
}

/// A layer needs its ghost cells, its skin and positive definiteness, each of which needs the one before.
void TransportedB::extend_layer(Material& m, int first_row) {
  const grid::RowSpan span{std::max(-Material::kGhost, first_row - Material::kGhost),
                           grid_.ny + Material::kGhost};
  const auto band = grid::rows(grid_, first_row, grid_.ny);
  fill_beyond_walls(m, first_row);
  halo_.fill({&m.phi}, span);
  if (height_) follow_surface(m, first_row);
  extend_shear(m, threshold_, grid_, band);
  fill_beyond_walls(m, first_row);
  halo_.fill({&m.B.xy, &m.B.xz, &m.B.yz}, span);
  limited_cells_ += extend_normal(m, threshold_, spec_.min_eigenvalue, grid_, band);
  fill_beyond_walls(m, first_row);
  halo_.fill({&m.B.xx, &m.B.yy, &m.B.zz}, span);
}

/// Derives phi, the share of the stress and the rows that are all solid from the surface, where it is a
/// height.
void TransportedB::follow_surface(Material& m, int first_row) {
  height_->follow(m.phi, first_row);
  share_.follow([this](int i, int k) { return height_->surface().flatness(i, k); });
  const auto phi = std::as_const(m.phi).view();
  const auto all_solid = [&](int j) {
    const grid::Box around{-1, grid_.nx + 1, j, j + 1, -1, grid_.nz + 1};
    return grid::max_cells(around, 0.0, [=](int i, int row, int k) { return 1 - phi(i, row, k); }) == 0;
  };
  m.all_solid_from = first_row;
  while (m.all_solid_from < grid_.ny && !all_solid(m.all_solid_from)) ++m.all_solid_from;
}

/// A body of any shape needs them in another order: B is made positive definite in the solid before its
/// surroundings take it, and then there (means of positive definite tensors are, but shear and normal
/// components live in different places).
void TransportedB::extend_body(Material& m) {
  constexpr int first_row = 0;
  const auto all = grid::all_cells(grid_);
  fill_beyond_walls(m, first_row);
  halo_.fill({&m.phi, &m.B.xy, &m.B.xz, &m.B.yz});
  normal_->extend_shear(m, threshold_);
  fill_beyond_walls(m, first_row);
  halo_.fill({&m.B.xy, &m.B.xz, &m.B.yz});
  limited_cells_ += keep_positive_definite(m.B, spec_.min_eigenvalue, all);
  halo_.fill({&m.B.xx, &m.B.yy, &m.B.zz});
  normal_->extend_normal(m, threshold_);
  limited_cells_ += keep_positive_definite(m.B, spec_.min_eigenvalue, all);
  fill_beyond_walls(m, first_row);
  halo_.fill({&m.B.xx, &m.B.yy, &m.B.zz});
}

/// Rows beyond a wall repeat the row at the wall; the velocity vanishes there, so little depends on them.
void TransportedB::fill_beyond_walls(Material& m, int first_row) const {
  const int ny = grid_.ny;
  const auto repeat = [=, this](grid::Field& field, int top) {
    const auto q = field.view();
    grid::for_each_cell(grid::rows(grid_, top + 1, ny + Material::kGhost),
                        [=](int i, int j, int k) { q(i, j, k) = q(i, top, k); });
    if (first_row > 0) return;
    grid::for_each_cell(grid::rows(grid_, -Material::kGhost, 0),
                        [=](int i, int j, int k) { q(i, j, k) = q(i, 0, k); });
  };
  for (grid::Field* center : {&m.phi, &m.B.xx, &m.B.yy, &m.B.zz, &m.B.xz}) repeat(*center, ny - 1);
  for (grid::Field* on_y_face : {&m.B.xy, &m.B.yz}) repeat(*on_y_face, ny);
}

}  // namespace softwall::solid
