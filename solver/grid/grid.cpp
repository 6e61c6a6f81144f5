#include "solver/grid/grid.hpp"

#include "solver/case/wall_normal_grid.hpp"

namespace softwall::grid {

namespace {

void fill_rows(Grid& g, const std::vector<double>& faces) {
  constexpr int ghost = RowArray::kGhost;
  const int ny = g.ny;
  g.y_face = g.y_center = g.dy = g.dy_face = g.inv_dy = g.inv_dy_face = g.upper_share = RowArray(ny);
  for (int j = 0; j <= ny; ++j) g.y_face.set(j, faces[static_cast<std::size_t>(j)]);
  for (int j = 1; j <= ghost; ++j) {
    g.y_face.set(-j, 2 * g.y_face[0] - g.y_face[j]);
    g.y_face.set(ny + j, 2 * g.y_face[ny] - g.y_face[ny - j]);
  }
  for (int j = -ghost; j < ny + ghost; ++j) {
    g.y_center.set(j, (g.y_face[j] + g.y_face[j + 1]) / 2);
    g.dy.set(j, g.y_face[j + 1] - g.y_face[j]);
    g.inv_dy.set(j, 1 / g.dy[j]);
  }
  for (int j = -ghost + 1; j < ny + ghost; ++j) {
    g.dy_face.set(j, g.y_center[j] - g.y_center[j - 1]);
    g.inv_dy_face.set(j, 1 / g.dy_face[j]);
    g.upper_share.set(j, g.dy[j] / (g.dy[j] + g.dy[j - 1]));
  }
}

}  // namespace

Grid make_grid(int nx, int nz, double length_x, double length_z, const std::vector<double>& faces,
               const parallel::Decomposition& decomposition) {
  Grid g;
  g.nx_global = nx;
  g.nz_global = nz;
  g.nx = decomposition.x().size();
  g.nz = decomposition.z().size();
  g.x_begin = decomposition.x().begin;
  g.z_begin = decomposition.z().begin;
  g.ny = static_cast<int>(faces.size()) - 1;
  g.ny_fluid = g.ny;
  g.length_x = length_x;
  g.length_z = length_z;
  g.height = faces.back() - faces.front();
  g.dx = length_x / nx;
  g.dz = length_z / nz;
  fill_rows(g, faces);
  return g;
}

Grid make_grid(const Physics& physics, const parallel::Decomposition& decomposition) {
  Grid g = make_grid(physics.grid.nx, physics.grid.nz, physics.length_x, physics.length_z,
                     wall_normal_faces(physics), decomposition);
  g.ny_fluid = physics.grid.ny_fluid;
  g.walls_in_x = is_closed_box(physics.flow);
  return g;
}

}  // namespace softwall::grid
