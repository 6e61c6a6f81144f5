#pragma once

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/interface_share.hpp"
#include "solver/solid/material.hpp"

/// Force of the neo-Hookean stress on the faces, f_i = d/dx_j [ phi G (B_ij - delta_ij) ], paper
/// eq:stress-s-he. phi G delta_ij is the gradient of a center field, which the pressure absorbs exactly on
/// this grid: it is left out, so that a wall at rest feels no force at all. For the same reason a multiple of
/// the identity added to B (as the limiter does) moves nothing.
namespace softwall::solid {

/// sum = force(now) + previous; then previous = force(now). Rows from first_row on; elsewhere both stay as
/// they are. `material` needs its ghost cells.
void renew_elastic_force(const Material& material, double G, const InterfaceShare& share, const Grid& grid,
                         int first_row, grid::VectorField& previous, grid::VectorField& sum);

}  // namespace softwall::solid
