#pragma once

#include "solver/grid/field.hpp"

namespace softwall::solid {

using grid::Grid;
using grid::Real;
using grid::View;

/// The solid's part of the state: fraction phi (0 fluid, 1 solid) at centers and the left Cauchy-Green tensor
/// B, normal components at centers, shear components on the edges where the shear of the staggered velocity
/// lives. (A centred B_xy cannot feel the two-cell mode of u(y); on the edges it can.)
struct Material {
  static constexpr int kGhost = 3;  ///< WENO reads three neighbours on either side
  grid::Field phi;
  grid::TensorField B;
  Material() = default;
  explicit Material(const Grid& g) : phi(g, kGhost), B(g, kGhost) {}
};

}  // namespace softwall::solid
