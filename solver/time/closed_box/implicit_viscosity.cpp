#include "solver/time/closed_box/implicit_viscosity.hpp"

#include "solver/grid/cell_loop.hpp"

namespace softwall::time {

namespace {

/// Rows where a component is predicted: v(i, 0, k) lies on the wall. (So does u(0, j, k), which the walls
/// set.)
grid::Box predicted(const grid::Grid& g, bool on_y_faces) { return grid::rows(g, on_y_faces ? 1 : 0, g.ny); }

}  // namespace

ImplicitViscosity::ImplicitViscosity(const grid::Grid& grid, const parallel::Decomposition& decomposition,
                                     double viscosity)
    : grid_(grid),
      viscosity_(viscosity),
      u_(grid, decomposition, pressure::BoxQuantity::kU),
      v_(grid, decomposition, pressure::BoxQuantity::kV),
      old_(grid, 0),
      viscous_(grid, 0) {}

void ImplicitViscosity::keep(const grid::VectorField& velocity, const Stage& stage, double dt) {
  const auto& g = grid_;
  const grid::Real twice = 2 * stage.alpha * dt * viscosity_, in_x = 1 / (g.dx * g.dx);
  const grid::Real *inv_dy = g.inv_dy.data(), *inv_dy_face = g.inv_dy_face.data();
  const auto u = velocity.x.view(), v = velocity.y.view();
  const auto old_u = old_.x.view(), old_v = old_.y.view(), rate_u = viscous_.x.view(),
             rate_v = viscous_.y.view();
  grid::for_each_cell(predicted(g, false), [=](int i, int j, int k) {
    old_u(i, j, k) = u(i, j, k);
    rate_u(i, j, k) = twice * ((u(i + 1, j, k) - 2 * u(i, j, k) + u(i - 1, j, k)) * in_x +
                               ((u(i, j + 1, k) - u(i, j, k)) * inv_dy_face[j + 1] -
                                (u(i, j, k) - u(i, j - 1, k)) * inv_dy_face[j]) *
                                   inv_dy[j]);
  });
  grid::for_each_cell(predicted(g, true), [=](int i, int j, int k) {
    old_v(i, j, k) = v(i, j, k);
    rate_v(i, j, k) =
        twice * ((v(i + 1, j, k) - 2 * v(i, j, k) + v(i - 1, j, k)) * in_x +
                 ((v(i, j + 1, k) - v(i, j, k)) * inv_dy[j] - (v(i, j, k) - v(i, j - 1, k)) * inv_dy[j - 1]) *
                     inv_dy_face[j]);
  });
}

void ImplicitViscosity::apply(grid::VectorField& velocity, const Stage& stage, double dt) {
  const double a = stage.alpha * dt * viscosity_;
  solve(u_, velocity.x, old_.x, viscous_.x, a);
  solve(v_, velocity.y, old_.y, viscous_.y, a);
}

void ImplicitViscosity::solve(pressure::BoxSolver& solver, grid::Field& velocity, const grid::Field& old,
                              const grid::Field& viscous, double a) const {
  const auto& g = grid_;
  const auto box = predicted(g, &solver == &v_);
  const auto q = velocity.view();
  const auto before = old.view(), rate = viscous.view();
  double* const dense = solver.values();
  const std::ptrdiff_t row = g.nx;
  grid::for_each_cell(box, [=](int i, int j, int k) {
    dense[i + j * row] = -(q(i, j, k) - before(i, j, k) + rate(i, j, k)) / a;
  });
  solver.solve(1 / a);
  grid::for_each_cell(box, [=](int i, int j, int k) { q(i, j, k) = before(i, j, k) + dense[i + j * row]; });
}

}  // namespace softwall::time
