#pragma once

#include "solver/solid/reference_map/surface.hpp"

/// The displacement below the surface: gradients in partly filled cells and the stencils of transport read
/// it, but the fluid has none. So it goes on along each column in a straight line from the two lowest points
/// in the solid (y is whole on every rank, and the solid is the top of every column). The slope of the line
/// is kept within bounds far from ordinary values, |d(d_x)/dy| <= 2 and -1 <= d(d_y)/dy <= 1/2: where two
/// points are torn apart, the line between them must not let the surface run away along the column.
namespace softwall::solid::reference_map {

/// Extrapolates the three components, where they live, down to row j0. heights: one column more on every
/// side. `displacement` on the upper wall must be set; ghost columns are not written.
void extrapolate(const Heights& heights, const Grid& grid, int j0, grid::VectorField& displacement);

}  // namespace softwall::solid::reference_map
