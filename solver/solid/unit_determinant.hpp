#pragma once

#include "solver/grid/halo.hpp"
#include "solver/solid/material.hpp"

/// Keeps det B = 1, which holds for any motion without divergence: B is divided by the cube root of its
/// determinant. Transport makes a mean of neighbouring B, and the mean of tensors of determinant 1 has a
/// larger one, so that without this the layer grew stiffer with every turn of a wave: det B reached 2.8 in a
/// layer of G = 0.25 after 58 h/U_b, 33 at G = 0.125 after 41. What B loses is of the order of the errors of
/// transport; to first order in the strain it is a pressure.
namespace softwall::solid {

class UnitDeterminant {
 public:
  UnitDeterminant(const Grid& grid, grid::Halo& halo) : grid_(grid), halo_(halo), scale_(grid, 1) {}

  /// Divides B in rows first_row and above: normal components by the factor of their cell, shear components
  /// by the mean of the four cells around them. Fills the ghost cells of B, and scales some of them: fill
  /// them again.
  void restore(grid::TensorField& B, int first_row);

 private:
  void find_scale(const grid::TensorField& B, int first_row);

  const Grid& grid_;
  grid::Halo& halo_;
  grid::Field scale_;  ///< det B to the power of -1/3, at centers
};

}  // namespace softwall::solid
