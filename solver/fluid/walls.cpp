#include "solver/fluid/walls.hpp"

#include "solver/grid/cell_loop.hpp"

namespace softwall::fluid {

namespace {

using grid::Box;
using grid::Field;

/// Row 0, to visit every column once: this rank's and its ghost columns in x. (Those in z get theirs from the
/// halo exchange afterwards.)
Box columns(const Field& f) { return {-f.ghost(), f.nx() + f.ghost(), 0, 1, 0, f.nz()}; }

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

/// All rows and planes beside the walls in x, ghost cells included.
Box wall_in_x(const Field& f) {
  return {0, 1, -f.ghost(), f.ny() + f.ghost(), -f.ghost(), f.nz() + f.ghost()};
}

void close_x(Field& f, const Walls& walls) {
  const auto u = f.view();
  const int nx = f.nx();
  grid::for_each_cell(wall_in_x(f), [=](int, int j, int k) {
    if (walls.low_x) {
      u(0, j, k) = 0;
      u(-1, j, k) = -u(1, j, k);
    }
    if (walls.high_x) u(nx, j, k) = 0;
  });
}

void mirror_x(Field& f, const Walls& walls) {
  const auto q = f.view();
  const int nx = f.nx();
  grid::for_each_cell(wall_in_x(f), [=](int, int j, int k) {
    if (walls.low_x) q(-1, j, k) = -q(0, j, k);
    if (walls.high_x) q(nx, j, k) = -q(nx - 1, j, k);
  });
}

}  // namespace

Walls walls_of(const grid::Grid& g) {
  Walls walls;
  walls.low_x = g.walls_in_x && g.x_begin == 0;
  walls.high_x = g.walls_in_x && g.x_begin + g.nx == g.nx_global;
  return walls;
}

void fill_ghosts(grid::VectorField& velocity, const Walls& walls, grid::Halo& halo) {
  halo.fill_in_x({&velocity.x, &velocity.y, &velocity.z}, {0, velocity.x.ny()});
  fill_other_ghosts(velocity, walls, halo);
}

void fill_other_ghosts(grid::VectorField& velocity, const Walls& walls, grid::Halo& halo) {
  mirror(velocity.x, walls.bottom_u, walls.top_u);
  close(velocity.y);
  mirror(velocity.z, 0, 0);
  halo.fill_in_z({&velocity.x, &velocity.y, &velocity.z}, {-1, velocity.x.ny() + 1});
  if (!walls.low_x && !walls.high_x) return;
  close_x(velocity.x, walls);
  mirror_x(velocity.y, walls);
  mirror_x(velocity.z, walls);
}

void fill_ghosts(grid::Field& center, grid::Halo& halo) {
  const auto q = center.view();
  const int ny = center.ny(), ghost = center.ghost();
  halo.fill_in_x({&center}, {0, ny});
  for (int layer = 1; layer <= ghost; ++layer) {
    grid::for_each_cell(columns(center), [=](int i, int, int k) {
      q(i, -layer, k) = q(i, 0, k);
      q(i, ny - 1 + layer, k) = q(i, ny - 1, k);
    });
  }
  halo.fill_in_z({&center}, {-ghost, ny + ghost});
}

}  // namespace softwall::fluid
