#include "solver/solid/transported_b/solid_edges.hpp"

#include "solver/solid/fraction.hpp"

namespace softwall::solid {

void mark_solid_edges(const Material& material, Real threshold, const Grid& g, int first_row,
                      SolidEdges& edges) {
  const Fraction phi{material.phi.view(), g.upper_share.data()};
  const auto xy = edges.xy.view(), xz = edges.xz.view(), yz = edges.yz.view();
  const grid::Box box{-1, g.nx + 1, first_row, g.ny + 1, -1, g.nz + 1};
  grid::for_each_cell(box, [=](int i, int j, int k) {
    xy(i, j, k) = phi.edge_xy(i, j, k) < threshold ? 0 : 1;
    xz(i, j, k) = phi.edge_xz(i, j, k) < threshold ? 0 : 1;
    yz(i, j, k) = phi.edge_yz(i, j, k) < threshold ? 0 : 1;
  });
}

}  // namespace softwall::solid
