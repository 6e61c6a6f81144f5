#pragma once

#include "solver/grid/halo.hpp"
#include "solver/solid/material.hpp"
#include "solver/solid/symmetric_tensor.hpp"

/// Keeps det B = 1, which holds for any motion without divergence. Transport makes a mean of neighbouring B,
/// and the mean of tensors of determinant 1 has a larger one, so that without this the layer grew stiffer
/// with every turn of a wave: det B reached 2.8 in a layer of G = 0.25 after 58 h/U_b, 33 at G = 0.125
/// after 41. What B loses is of the order of the errors of transport; to first order in the strain it is a
/// pressure.
namespace softwall::solid {

/// The factor of the normal components that gives B the determinant 1, found by one step of Newton's
/// iteration from 1 and kept between 0.9 and 1.1. It is 1 where B is far from the B of any strain, which the
/// limiter will mend.
[[nodiscard]] double factor_of_normals(const SymmetricTensor& B);

/// The share of the determinant's error that a substep of this length [h/U_b] takes away. The error grows
/// over tens of h/U_b, so that it suffices to remove it within two; this slowly, what a passing wave changes
/// in the means at centers hardly counts.
[[nodiscard]] inline double restored_share(double duration) {
  constexpr double kTime = 2;  // h/U_b
  return duration < kTime ? duration / kTime : 1;
}

/// Changes the normal components in rows first_row and above by a share of what the factor of their cell asks
/// for. The shear components stay: a layer at rest holds its load by them, and to scale them by what their
/// means at centers leave of the determinant would let it creep forever. Fills the shear components' ghost
/// cells.
void restore_unit_determinant(grid::TensorField& B, const Grid& grid, grid::Halo& halo, int first_row,
                              double share);

}  // namespace softwall::solid
