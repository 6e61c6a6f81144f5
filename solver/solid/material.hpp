#pragma once

#include <limits>

#include "solver/case/case.hpp"
#include "solver/grid/field.hpp"

namespace softwall::solid {

using grid::Grid;
using grid::Real;
using grid::View;

/// Less phi than this is dust: it stays where it is, without effect.
inline constexpr double kDust = 0.02;

/// The solid: fraction phi (0 fluid, 1 solid) at centers and the left Cauchy-Green tensor B, normal
/// components at centers, shear components on the edges where the shear of the staggered velocity lives. (A
/// centred B_xy cannot feel the two-cell mode of u(y); on the edges it can.)
///
/// With the formulation kTransportedB phi and B are the state. With kReferenceMap the displacement is, and
/// phi and B follow from it (solid.hpp: start, transport).
struct Material {
  static constexpr int kGhost = 3;  ///< WENO reads three neighbours on either side
  SolidFormulation formulation = SolidFormulation::kTransportedB;
  grid::Field phi;
  grid::TensorField B;
  /// The displacement d, h: the material now at x was at x - d. Its components live where those of the
  /// velocity do.
  grid::VectorField displacement;
  double surface_at_rest = 0;  ///< height that the solid's surface had before it was deformed, h
  /// phi is known to be 1 from this row on, in the ghost columns and planes next to this rank's, too.
  int all_solid_from = std::numeric_limits<int>::max();
  /// Returns the first row whose lower edges, and all edges above, are known to lie in the solid; ny where
  /// none are.
  [[nodiscard]] int solid_edges_from(int ny) const { return all_solid_from < ny ? all_solid_from + 1 : ny; }

  Material() = default;
  explicit Material(const Grid& g) : phi(g, kGhost), B(g, kGhost), displacement(g, kGhost) {}
};

}  // namespace softwall::solid
