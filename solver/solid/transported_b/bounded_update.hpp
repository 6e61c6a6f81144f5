#pragma once

#include "solver/grid/halo.hpp"
#include "solver/grid/stage.hpp"

/// A substep of a fraction in flux form that keeps it between 0 and 1 and its sum constant,
///   phi^k = phi^{k-1} - div(L) - div(C A),   L + A = dt [ beta F^{k-1} + gamma F^{k-2} ],
/// after Zalesak, J. Comput. Phys. 31 (1979). L, what first-order upwinding would carry with the velocity of
/// the substep beta u^{k-1} + gamma u^{k-2}, is free of divergence where phi is constant and keeps the bounds
/// while no more than a cell's content leaves it in a substep. C, between 0 and 1 on each face, is the
/// largest share of the rest for which neither of its two cells could leave the bounds.
namespace softwall::solid {

using grid::Grid;
using grid::Real;

class BoundedUpdate {
 public:
  BoundedUpdate(const Grid& grid, grid::Halo& halo);

  /// flux: F^{k-1} on the low faces of the cells of rows j >= first_row and on the last high ones; nothing
  /// crosses the low face of the first row and the upper wall. Ghost cells of phi: filled on entry, not on
  /// return. flux holds work on return, velocity is remembered with it for the next substep.
  void advance(grid::Field& phi, grid::VectorField& flux, const grid::VectorField& velocity,
               const Stage& stage, double dt, int first_row);

 private:
  void split(const grid::Field& phi, const grid::VectorField& flux, const grid::VectorField& velocity,
             const Stage& stage, double dt, int first_row);
  void subtract_divergence(grid::Field& phi, const grid::VectorField& amount, int first_row) const;
  void find_room(const grid::Field& phi, int first_row);
  void limit(int first_row);
  void remember(grid::VectorField& flux, const grid::VectorField& velocity, int first_row);

  const Grid& grid_;
  grid::Halo& halo_;
  grid::VectorField flux_before_;      ///< F^{k-2}; then A
  grid::VectorField velocity_before_;  ///< u^{k-2}; then L
  grid::Field rise_, fall_;            ///< share of what A brings in, or takes out, that a cell has room for
};

}  // namespace softwall::solid
