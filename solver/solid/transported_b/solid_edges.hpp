#pragma once

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/material.hpp"
#include "solver/solid/transported_b/stretching.hpp"

/// Which edges lie in the solid: those whose own shear, and not the fluid's, stretches it.
namespace softwall::solid {

/// 1 on edges in the solid, 0 on those that touch the fluid; one ghost layer in x and z is right too.
struct SolidEdges {
  grid::Field xy, xz, yz;
  explicit SolidEdges(const Grid& g) : xy(g, 1), xz(g, 1), yz(g, 1) {}
  [[nodiscard]] EdgeMarks marks() const { return {xy.view(), xz.view(), yz.view()}; }
};

/// Marks the edges of rows first_row <= j <= ny where phi, averaged to the edge, is at least `threshold`.
void mark_solid_edges(const Material& material, Real threshold, const Grid& grid, int first_row,
                      SolidEdges& edges);

}  // namespace softwall::solid
