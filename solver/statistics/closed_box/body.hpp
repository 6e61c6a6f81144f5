#pragma once

#include "solver/grid/grid.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::statistics {

/// A solid in a closed box at one moment, as a figure in the x-y plane.
struct Body {
  double centroid_x = 0, centroid_y = 0;              ///< of phi, h
  double area = 0;                                    ///< sum of phi dx dy, h^2
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;  ///< of the isoline phi = 1/2, linear between centers, h
  double width_cells = 0;                             ///< 10-90 % width of phi across its outline
};

/// Collective; ghost cells of phi filled. The width is that of a phi that rises linearly across the outline,
/// whose integral of 4 phi (1 - phi) along the normal is 2/3 of the whole width:
///   width_cells = 0.8 * 3/2 integral 4 phi (1 - phi) dA / (dx integral |grad phi| dA).
[[nodiscard]] Body body_of(const grid::Field& phi, const grid::Grid& grid,
                           const parallel::Decomposition& decomposition);

/// Energies of the box over its depth, rho U_b^2 h^2.
struct BoxEnergy {
  double kinetic = 0;  ///< (u^2 + v^2) / 2
  double elastic = 0;  ///< phi G (tr B - 3) / 2
};
[[nodiscard]] BoxEnergy energy_of(const time::State& state, const time::Setup& setup);

}  // namespace softwall::statistics
