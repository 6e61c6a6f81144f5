#pragma once

#include "solver/grid/field.hpp"

namespace softwall {

/// What the solid hands to the momentum equation; an absent one (rigid channel) has no rows.
struct SolidInput {
  const grid::Field* fraction = nullptr;     ///< phi, ghost cells filled
  const grid::VectorField* force = nullptr;  ///< f^k + f^{k-1} on the faces
  int first_row = 0;                         ///< phi and force vanish below this row
  double viscosity_ratio = 1;
};

}  // namespace softwall
