#pragma once

#include "solver/fluid/momentum_sweep.hpp"
#include "solver/grid/field.hpp"
#include "solver/grid/solid_input.hpp"
#include "solver/grid/stage.hpp"

/// Predicted velocity of a substep, paper eq:NS-num1:
///   u* = u^{k-1} + dt [ -2 alpha grad p^{k-1} + alpha (f_now + f_before) + beta R^{k-1} + gamma R^{k-2} ]
/// with R the convective and viscous terms, those of the solid's own viscosity among them, and f_now and
/// f_before the elastic forces of SolidInput: f^k and f^{k-1} in the explicit scheme of the paper, equation
/// (8) of solver/README.md. In the implicit one, the default, both are the force of the middle of the step,
/// and the result is u^ of (17) in solver/solid/README.md, from which solid/row_stiffness.hpp makes u*. The
/// uniform driving gradient comes after the projection (forcing.hpp): the two commute.
namespace softwall::fluid {

class Predictor {
 public:
  Predictor(const Grid& grid, double viscosity);

  /// Replaces `velocity` by u*. Ghost cells are read from the old velocity and not filled in the new one,
  /// except that the wall-normal component is 0 on the walls.
  void advance(grid::VectorField& velocity, const grid::Field& pressure, const SolidInput& solid,
               const Stage& stage, double dt);

  /// The velocity before advance(), without its ghost cells.
  [[nodiscard]] const grid::VectorField& velocity_before() const { return predicted_; }

 private:
  const Grid& grid_;
  double viscosity_;
  MomentumSweep sweep_;
  grid::VectorField rate_;       ///< R^{k-2} on entry, R^{k-1} on return
  grid::VectorField predicted_;  ///< u*, exchanged with the velocity at the end
};

}  // namespace softwall::fluid
