#pragma once

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::statistics {

inline constexpr const char* kDetErrorMeaning =
    "largest |det B - 1| in the solid in the block; with a reference map, of F F^T before its volume is set "
    "right";

/// Signs of a solid that is well resolved, or not.
struct SolidHealth {
  double min_eigenvalue = 1;         ///< smallest eigenvalue of B at any center of the rows that hold solid
  double max_det_error = 0;          ///< max |det B - 1| over centers with phi >= the case's threshold;
                                     ///< with a reference map, of F F^T before its volume is set right
  double interface_width_cells = 0;  ///< 10-90 % width of phi in cells, mean over columns (a sharp step: 0.8)
                                     ///< or, in a closed box, along the outline (body.hpp)
  double solid_volume = 0;           ///< sum of phi dV over the box, h^3; constant to round-off
                                     ///< with transported B
};

/// Health of the solid, the same on all ranks. Collective; ghost cells of B filled (after time::start or a
/// step). A rigid channel has no solid and gets the values above.
[[nodiscard]] SolidHealth solid_health(const time::State& state, const time::Setup& setup);

/// Sum of phi: how many cells the solid would fill. Collective.
[[nodiscard]] double solid_cells(const time::State& state, const time::Setup& setup);

}  // namespace softwall::statistics
