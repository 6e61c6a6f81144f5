#include "solver/solid/transported_b/bounded_update.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solver/grid/cell_loop.hpp"

namespace softwall::solid {

namespace {

using grid::View;

/// The faces of one direction through which something may flow, and the step from a face's low cell to its
/// high one, whose index is the face's.
struct Faces {
  grid::Box box;
  int x, y, z;
};

std::array<Faces, 3> faces_of(const Grid& g, int first_row) {
  return {{{{0, g.nx + 1, first_row, g.ny, 0, g.nz}, 1, 0, 0},
           {{0, g.nx, first_row + 1, g.ny, 0, g.nz}, 0, 1, 0},
           {{0, g.nx, first_row, g.ny, 0, g.nz + 1}, 0, 0, 1}}};
}

std::array<grid::Field*, 3> components(grid::VectorField& v) { return {&v.x, &v.y, &v.z}; }
std::array<const grid::Field*, 3> components(const grid::VectorField& v) { return {&v.x, &v.y, &v.z}; }

/// Amounts on the faces of a cell, over its size.
struct Sides {
  View<const Real> x, y, z;
  const Real* inv_dy;
  Real inv_dx, inv_dz;

  Real divergence(int i, int j, int k) const {
    return (x(i + 1, j, k) - x(i, j, k)) * inv_dx + (y(i, j + 1, k) - y(i, j, k)) * inv_dy[j] +
           (z(i, j, k + 1) - z(i, j, k)) * inv_dz;
  }
  /// All that comes in; what goes out is this less the sum.
  Real inflow(int i, int j, int k) const {
    const auto in = [](Real low, Real high) { return (low > 0 ? low : 0) - (high < 0 ? high : 0); };
    return in(x(i, j, k), x(i + 1, j, k)) * inv_dx + in(y(i, j, k), y(i, j + 1, k)) * inv_dy[j] +
           in(z(i, j, k), z(i, j, k + 1)) * inv_dz;
  }
};

Sides sides_of(const grid::VectorField& amount, const Grid& g) {
  return {amount.x.view(), amount.y.view(), amount.z.view(), g.inv_dy.data(), Real(1 / g.dx), Real(1 / g.dz)};
}

}  // namespace

BoundedUpdate::BoundedUpdate(const Grid& grid, grid::Halo& halo)
    : grid_(grid),
      halo_(halo),
      flux_before_(grid, 1),
      velocity_before_(grid, 1),
      rise_(grid, 1),
      fall_(grid, 1) {}

void BoundedUpdate::advance(grid::Field& phi, grid::VectorField& flux, const grid::VectorField& velocity,
                            const Stage& stage, double dt, int first_row) {
  split(phi, flux, velocity, stage, dt, first_row);
  const grid::VectorField &low_order = velocity_before_, &rest = flux_before_;
  subtract_divergence(phi, low_order, first_row);
  find_room(phi, first_row);
  limit(first_row);
  subtract_divergence(phi, rest, first_row);
  remember(flux, velocity, first_row);
}

/// L and A take the place of what they are made of.
void BoundedUpdate::split(const grid::Field& phi, const grid::VectorField& flux,
                          const grid::VectorField& velocity, const Stage& stage, double dt, int first_row) {
  const Real by_now = Real(stage.beta * dt), by_before = Real(stage.gamma * dt);
  const auto q = phi.view();
  const auto faces = faces_of(grid_, first_row);
  for (std::size_t d = 0; d < 3; ++d) {
    const Faces f = faces[d];
    const auto u = components(velocity)[d]->view(), flux_now = components(flux)[d]->view();
    const auto u_before = components(velocity_before_)[d]->view(),
               flux_before = components(flux_before_)[d]->view();
    grid::for_each_cell(f.box, [=](int i, int j, int k) {
      const Real carrier = by_now * u(i, j, k) + by_before * u_before(i, j, k);
      const Real below = q(i - f.x, j - f.y, k - f.z), above = q(i, j, k);
      const Real low_order = carrier * (carrier > 0 ? below : above);
      const Real whole = by_now * flux_now(i, j, k) + by_before * flux_before(i, j, k);
      u_before(i, j, k) = low_order;
      flux_before(i, j, k) = whole - low_order;
    });
  }
  for (const int closed : {first_row, grid_.ny}) {
    const auto low_order = velocity_before_.y.view(), rest = flux_before_.y.view();
    grid::for_each_cell(grid::rows(grid_, closed, closed + 1),
                        [=](int i, int j, int k) { low_order(i, j, k) = rest(i, j, k) = 0; });
  }
}

void BoundedUpdate::subtract_divergence(grid::Field& phi, const grid::VectorField& amount,
                                        int first_row) const {
  const Sides sides = sides_of(amount, grid_);
  const auto q = phi.view();
  grid::for_each_cell(grid::rows(grid_, first_row, grid_.ny),
                      [=](int i, int j, int k) { q(i, j, k) -= sides.divergence(i, j, k); });
}

void BoundedUpdate::find_room(const grid::Field& phi, int first_row) {
  const Sides sides = sides_of(flux_before_, grid_);
  const auto q = phi.view();
  const auto rise = rise_.view(), fall = fall_.view();
  const auto share = [](Real room, Real wanted) {
    const Real left = room > 0 ? room : 0;  // round-off may have taken more than there was
    return wanted > left ? left / wanted : Real(1);
  };
  grid::for_each_cell(grid::rows(grid_, first_row, grid_.ny), [=](int i, int j, int k) {
    const Real in = sides.inflow(i, j, k), out = in + sides.divergence(i, j, k);
    rise(i, j, k) = share(1 - q(i, j, k), in);
    fall(i, j, k) = share(q(i, j, k), out);
  });
  halo_.fill({&rise_, &fall_}, {first_row, grid_.ny});
}

void BoundedUpdate::limit(int first_row) {
  const auto rise = std::as_const(rise_).view(), fall = std::as_const(fall_).view();
  const auto faces = faces_of(grid_, first_row);
  for (std::size_t d = 0; d < 3; ++d) {
    const Faces f = faces[d];
    const auto rest = components(flux_before_)[d]->view();
    grid::for_each_cell(f.box, [=](int i, int j, int k) {
      const Real upward = std::min(fall(i - f.x, j - f.y, k - f.z), rise(i, j, k));
      const Real downward = std::min(rise(i - f.x, j - f.y, k - f.z), fall(i, j, k));
      rest(i, j, k) *= rest(i, j, k) > 0 ? upward : downward;
    });
  }
}

void BoundedUpdate::remember(grid::VectorField& flux, const grid::VectorField& velocity, int first_row) {
  std::swap(flux_before_, flux);
  const auto faces = faces_of(grid_, first_row);
  for (std::size_t d = 0; d < 3; ++d) {
    const auto from = components(velocity)[d]->view();
    const auto to = components(velocity_before_)[d]->view();
    grid::for_each_cell(faces[d].box, [=](int i, int j, int k) { to(i, j, k) = from(i, j, k); });
  }
}

}  // namespace softwall::solid
