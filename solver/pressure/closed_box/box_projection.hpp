#pragma once

#include "solver/grid/halo.hpp"
#include "solver/grid/stage.hpp"
#include "solver/pressure/closed_box/box_solver.hpp"

namespace softwall::pressure {

using grid::Real;

/// What Projection is to a channel, for a closed box: makes the predicted velocity divergence-free and
/// updates the pressure, paper eq:NS-num2 and eq:NS-num3:
///   laplacian(psi) = div(u*) / (2 alpha dt),   u = u* - 2 alpha dt grad psi,   p += psi.
class BoxProjection {
 public:
  /// `halo` repeats columns beyond the walls: psi has no gradient there.
  BoxProjection(const Grid& grid, const parallel::Decomposition& decomposition, grid::Halo& halo);

  /// `velocity` with all ghost cells filled on entry; interior divergence-free on return, ghost cells stale,
  /// those of the pressure too.
  void project(grid::VectorField& velocity, grid::Field& pressure, const Stage& stage, double dt);

 private:
  const Grid& grid_;
  grid::Halo& halo_;
  BoxSolver solver_;
  grid::Field psi_;
};

}  // namespace softwall::pressure
