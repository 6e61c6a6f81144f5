#include "solver/fluid/walls.hpp"

#include "solver/grid/cell_loop.hpp"

namespace softwall::fluid {

namespace {

using grid::Box;
using grid::Field;

/// Interior columns of row 0: one visit a column. (Ghost columns get theirs from the halo exchange
/// afterwards.)
Box columns(const Field& f) { return {0, f.nx(), 0, 1, 0, f.nz()}; }

void mirror(Field& f, Real bottom, Real top) {
  const auto q = f.view();
  const int ny = f.ny();
  grid::for_each_cell(columns(f), [=](int i, int, int k) {
    q(i, -1, k) = 2 * bottom - q(i, 0, k);
    q(i, ny, k) = 2 * top - q(i, ny - 1, k);
  });
}

void close(Field& f) {
  const auto v = f.view();
  const int ny = f.ny();
  grid::for_each_cell(columns(f), [=](int i, int, int k) {
    v(i, 0, k) = 0;
    v(i, ny, k) = 0;
    v(i, -1, k) = -v(i, 1, k);
  });
}

}  // namespace

void fill_ghosts(grid::VectorField& velocity, const Walls& walls, grid::Halo& halo) {
  mirror(velocity.x, walls.bottom_u, walls.top_u);
  close(velocity.y);
  mirror(velocity.z, 0, 0);
  halo.fill({&velocity.x, &velocity.y, &velocity.z});
}

void fill_ghosts(grid::Field& center, grid::Halo& halo) {
  const auto q = center.view();
  const int ny = center.ny();
  for (int layer = 1; layer <= center.ghost(); ++layer) {
    grid::for_each_cell(columns(center), [=](int i, int, int k) {
      q(i, -layer, k) = q(i, 0, k);
      q(i, ny - 1 + layer, k) = q(i, ny - 1, k);
    });
  }
  halo.fill({&center});
}

}  // namespace softwall::fluid
