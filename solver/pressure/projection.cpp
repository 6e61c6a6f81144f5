#include "solver/pressure/projection.hpp"

#include <cmath>
#include <utility>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"

namespace softwall::pressure {

Projection::Projection(const Grid& grid, const parallel::Decomposition& decomposition, grid::Halo& halo)
    : grid_(grid), halo_(halo), poisson_(grid, decomposition), psi_(grid, 1) {}

void Projection::project(grid::VectorField& velocity, grid::Field& pressure, const Stage& stage, Real dt) {
  const auto& g = grid_;
  const Real duration = 2 * stage.alpha * dt, inv_duration = 1 / duration;
  const Real inv_dx = 1 / g.dx, inv_dz = 1 / g.dz;
  const Real *inv_dy = g.inv_dy.data(), *inv_dy_face = g.inv_dy_face.data();
  const auto u = velocity.x.view(), v = velocity.y.view(), w = velocity.z.view();
  const auto& c = std::as_const(velocity);
  const auto cu = c.x.view(), cv = c.y.view(), cw = c.z.view();
  Real* const dense = poisson_.values();
  const std::ptrdiff_t row = g.nx, plane = row * g.ny;

  grid::for_each_cell(grid::all_cells(g), [=](int i, int j, int k) {
    dense[i + j * row + k * plane] =
        inv_duration * divergence(cu, cv, cw, inv_dx, inv_dy[j], inv_dz, i, j, k);
  });
  poisson_.solve();

  const auto psi = psi_.view(), p = pressure.view();
  grid::for_each_cell(grid::all_cells(g), [=](int i, int j, int k) {
    psi(i, j, k) = dense[i + j * row + k * plane];
    p(i, j, k) += psi(i, j, k);
  });
  halo_.fill({&psi_}, {0, g.ny});
  grid::for_each_cell(grid::all_cells(g), [=](int i, int j, int k) {
    u(i, j, k) -= duration * (psi(i, j, k) - psi(i - 1, j, k)) * inv_dx;
    w(i, j, k) -= duration * (psi(i, j, k) - psi(i, j, k - 1)) * inv_dz;
  });
  grid::for_each_cell(grid::rows(g, 1, g.ny), [=](int i, int j, int k) {
    v(i, j, k) -= duration * (psi(i, j, k) - psi(i, j - 1, k)) * inv_dy_face[j];
  });
}

double max_divergence(const grid::VectorField& velocity, const Grid& g,
                      const parallel::Decomposition& decomposition) {
  const auto u = velocity.x.view(), v = velocity.y.view(), w = velocity.z.view();
  const Real inv_dx = 1 / g.dx, inv_dz = 1 / g.dz;
  const Real* inv_dy = g.inv_dy.data();
  const double here = grid::max_cells(grid::all_cells(g), 0.0, [=](int i, int j, int k) {
    return std::abs(divergence(u, v, w, inv_dx, inv_dy[j], inv_dz, i, j, k));
  });
  return parallel::maximum(decomposition.all(), here);
}

}  // namespace softwall::pressure
