#pragma once

#include "solver/solid/transported_b/bounded_update.hpp"

/// Transport of phi as an algebraic volume of fluid: phi is carried through each face with the mean value
/// that the smoothed step in the upwind cell (thinc.hpp) has there, so that the interface keeps its width
/// however far it travels, phi its sum and its bounds (bounded_update.hpp).
///
/// A cell that is all but full or empty, or has no gradient to tell on which side the solid is, carries its
/// phi. The step's normal is the mean gradient over the cell's eight corners (Youngs), in cells rather than
/// lengths: the interface is equally many cells wide in every direction.
namespace softwall::solid {

class FractionTransport {
 public:
  FractionTransport(const Grid& grid, grid::Halo& halo);

  /// One substep, in rows from first_row on; nothing crosses the low face of the first. Ghost cells of phi
  /// and velocity: filled on entry, those of phi not on return.
  void advance(grid::Field& phi, const grid::VectorField& velocity, const Stage& stage, double dt,
               int first_row);

 private:
  void carry_upwind(const grid::Field& phi, const grid::VectorField& velocity, int first_row);
  void carry_steps(const grid::Field& phi, const grid::VectorField& velocity, int first_row);

  const Grid& grid_;
  BoundedUpdate update_;
  grid::VectorField flux_;
};

}  // namespace softwall::solid
