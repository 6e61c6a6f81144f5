#pragma once

#include <cstdint>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/material.hpp"

/// Partly filled cells: the thin skin where the smeared phi falls from 1 to 0 is sheared by the fluid without
/// bound, and what B becomes there says nothing about the solid. So wherever phi is below a threshold, B is
/// taken from the solid above it in the same column (y is whole on every rank, the solid is the top of every
/// column). Below a flat layer at rest the stress then falls from G B_xy to zero in proportion to phi while
/// the viscous stress of the fluid rises in proportion to 1 - phi: the mean interface acts exactly where phi
/// places it.
namespace softwall::solid {

/// Replaces the shear components in the rows of the box, wherever phi (averaged to the place of each) is
/// below `threshold` or any place above it is, by the value in the row above.
void extend_shear(Material& material, Real threshold, const Grid& grid, const grid::Box& box);

/// Extends the normal components in the same way; each row is kept positive definite (limiter.hpp) before the
/// next one below takes its values, so that doing it again changes no bit. Shear ghost cells must be filled.
/// Returns the number of cells limited here.
std::int64_t extend_normal(Material& material, Real threshold, double floor, const Grid& grid,
                           const grid::Box& box);

}  // namespace softwall::solid
