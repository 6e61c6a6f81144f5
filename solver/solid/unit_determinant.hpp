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

/// By how much the normal components must be multiplied for B to have the determinant 1, after one step of
/// Newton's iteration from 1; at most a tenth more or less. 1 where B is far from a strain: its limiter will
/// lift it.
[[nodiscard]] double factor_of_normals(const SymmetricTensor& B);

/// Multiplies the normal components in rows first_row and above, by the factor of their cell. The shear
/// components stay: a layer at rest holds its load by them, and to scale them by what their means at centers
/// leave of the determinant would let it creep for ever. Fills the shear components' ghost cells.
void restore_unit_determinant(grid::TensorField& B, const Grid& grid, grid::Halo& halo, int first_row);

}  // namespace softwall::solid
