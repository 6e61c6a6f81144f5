#include "solver/pressure/closed_box/box_projection.hpp"

#include "solver/grid/cell_loop.hpp"
#include "solver/pressure/projection.hpp"

namespace softwall::pressure {

BoxProjection::BoxProjection(const Grid& grid, const parallel::Decomposition& decomposition, grid::Halo& halo)
    : grid_(grid), halo_(halo), solver_(grid, decomposition, BoxQuantity::kPressure), psi_(grid, 1) {}

void BoxProjection::project(grid::VectorField& velocity, grid::Field& pressure, const Stage& stage,
                            double dt) {
  const auto& g = grid_;
  const Real duration = static_cast<Real>(2 * stage.alpha * dt), inv_dx = static_cast<Real>(1 / g.dx);
  const Real *inv_dy = g.inv_dy.data(), *inv_dy_face = g.inv_dy_face.data();
  const auto u = velocity.x.view(), v = velocity.y.view();
  const Divergence divergence(velocity, g);
  double* const dense = solver_.values();
  const std::ptrdiff_t row = g.nx;
  const auto all = grid::all_cells(g);

  grid::for_each_cell(all, [=](int i, int j, int k) {
    dense[i + j * row] = double(divergence.at(i, j, k, inv_dy[j])) / duration;
  });
  solver_.solve(0);
  const auto psi = psi_.view(), p = pressure.view();
  grid::for_each_cell(all, [=](int i, int j, int k) {
    psi(i, j, k) = static_cast<Real>(dense[i + j * row]);
    p(i, j, k) += psi(i, j, k);
  });
  halo_.fill({&psi_}, {0, g.ny});
  grid::for_each_cell(
      all, [=](int i, int j, int k) { u(i, j, k) -= duration * (psi(i, j, k) - psi(i - 1, j, k)) * inv_dx; });
  grid::for_each_cell(grid::rows(g, 1, g.ny), [=](int i, int j, int k) {
    v(i, j, k) -= duration * (psi(i, j, k) - psi(i, j - 1, k)) * inv_dy_face[j];
  });
}

}  // namespace softwall::pressure
