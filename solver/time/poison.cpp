#include "solver/time/poison.hpp"

#include <limits>

#include "solver/grid/cell_loop.hpp"

namespace softwall::time {

namespace {

using grid::Field;
using grid::Real;

void poison(Field& field, const grid::Box& box) {
  const auto q = field.view();
  grid::for_each_cell(box, [=](int i, int j, int k) { q(i, j, k) = std::numeric_limits<Real>::quiet_NaN(); });
}

void poison_beyond_y(Field& f, int top) {
  const int n = f.ghost();
  poison(f, {-n, f.nx() + n, -n, 0, -n, f.nz() + n});
  poison(f, {-n, f.nx() + n, top, f.ny() + n, -n, f.nz() + n});
}

void poison_high_x_and_z(Field& f) {
  const int n = f.ghost();
  poison(f, {f.nx(), f.nx() + n, -n, f.ny() + n, -n, f.nz() + n});
  poison(f, {-n, f.nx() + n, -n, f.ny() + n, f.nz(), f.nz() + n});
}

void poison_all(Field& f, int top) {
  const int n = f.ghost();
  poison_beyond_y(f, top);
  poison_high_x_and_z(f);
  poison(f, {-n, 0, -n, f.ny() + n, -n, f.nz() + n});
  poison(f, {-n, f.nx() + n, -n, f.ny() + n, -n, 0});
}

}  // namespace

void poison_ghosts(grid::VectorField& velocity) {
  poison_all(velocity.x, velocity.x.ny());
  poison_all(velocity.y, velocity.y.ny() + 1);
  poison_all(velocity.z, velocity.z.ny());
}

void poison_unread_ghosts(Field& pressure) {
  poison_beyond_y(pressure, pressure.ny());
  poison_high_x_and_z(pressure);
}

}  // namespace softwall::time
