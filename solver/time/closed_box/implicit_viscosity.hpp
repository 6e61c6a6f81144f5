#pragma once

#include "solver/fluid/walls.hpp"
#include "solver/grid/stage.hpp"
#include "solver/pressure/closed_box/box_solver.hpp"

/// Viscous terms of a closed box of one viscosity, implicit (Crank-Nicolson), where an explicit step would be
/// limited to about dx^2 / (4 nu):
///   u* = u^ + alpha dt nu laplacian(u* + u^{k-1}),
/// u^ being the predicted velocity without viscosity. Solved for the change du = u* - u^{k-1}, which vanishes
/// on the walls whatever their motion:
///   (1 - a laplacian) du = u^ - u^{k-1} + 2 a laplacian(u^{k-1}),   a = alpha dt nu.
/// (Le & Moin, J. Comput. Phys. 92, 1991: second order, stable for any a.)
namespace softwall::time {

class ImplicitViscosity {
 public:
  ImplicitViscosity(const grid::Grid& grid, const parallel::Decomposition& decomposition, double viscosity);

  /// Before the prediction: keeps u^{k-1}, whose ghost cells must be filled, and its viscous part.
  void keep(const grid::VectorField& velocity, const Stage& stage, double dt);
  /// After it: replaces u^ by u*. Ghost cells are stale.
  void apply(grid::VectorField& velocity, const Stage& stage, double dt);

 private:
  void solve(pressure::BoxSolver& solver, grid::Field& velocity, const grid::Field& old,
             const grid::Field& viscous, double a) const;

  const grid::Grid& grid_;
  const double viscosity_;
  pressure::BoxSolver u_, v_;
  grid::VectorField old_, viscous_;  ///< u^{k-1}; 2 a laplacian(u^{k-1})
};

}  // namespace softwall::time
