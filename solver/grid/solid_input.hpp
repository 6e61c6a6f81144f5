#pragma once

#include <limits>

#include "solver/grid/field.hpp"

namespace softwall {

/// What the solid hands to the momentum equation; an absent one (rigid channel) has no rows.
struct SolidInput {
  const grid::Field* fraction = nullptr;  ///< phi, ghost cells filled
  /// Elastic force on the faces at the end and the beginning of the substep, f^k and f^{k-1}, where the
  /// stress between rows is explicit; where it is implicit, by default, both are the force of the middle of
  /// the step, equation (16) of solver/solid/README.md.
  const grid::VectorField *force_now = nullptr, *force_before = nullptr;
  int first_row = 0;  ///< below it there is no solid; phi and forces are not to be read there
  double viscosity_ratio = 1;
  double ratio_across = 1;  ///< the same for what is explicit of viscosity between rows
  int fluid_end_row = std::numeric_limits<int>::max();  ///< no fluid from this row on, as far as is known
  /// What the fluid's viscous force lacks at moment k-1, over mu_f; absent when nothing does.
  const grid::VectorField* excess_viscous = nullptr;
  int excess_end_row = 0;  ///< it vanishes from this row on
  /// The part of it that acts between rows where that is implicit, and is then not in `excess_viscous`.
  const grid::VectorField* excess_across = nullptr;
  /// How many times the fluid's viscosity counts at an edge on the interface (solid/interface_share.hpp).
  double interface_viscosity = 1;
};

}  // namespace softwall
