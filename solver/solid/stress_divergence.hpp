#pragma once

#include <algorithm>

#include "solver/grid/cell_loop.hpp"
#include "solver/grid/field.hpp"

/// Force of a stress whose normal components live at centers and shear components on edges, as those of B do.
namespace softwall::solid {

using grid::Real;

/// f_i = d s_ij / dx_j on the faces. Stress: xx(i, j, k), ..., yz(i, j, k), where the components live.
template <class Stress>
struct StressDivergence {
  Stress s;
  const Real *inv_dy, *inv_dy_face;
  Real inv_dx, inv_dz;

  StressDivergence(const Stress& stress, const grid::Grid& g)
      : s(stress),
        inv_dy(g.inv_dy.data()),
        inv_dy_face(g.inv_dy_face.data()),
        inv_dx(Real(1 / g.dx)),
        inv_dz(Real(1 / g.dz)) {}

  Real x(int i, int j, int k) const {
    return (s.xx(i, j, k) - s.xx(i - 1, j, k)) * inv_dx + (s.xy(i, j + 1, k) - s.xy(i, j, k)) * inv_dy[j] +
           (s.xz(i, j, k + 1) - s.xz(i, j, k)) * inv_dz;
  }
  Real y(int i, int j, int k) const {
    return (s.xy(i + 1, j, k) - s.xy(i, j, k)) * inv_dx +
           (s.yy(i, j, k) - s.yy(i, j - 1, k)) * inv_dy_face[j] +
           (s.yz(i, j, k + 1) - s.yz(i, j, k)) * inv_dz;
  }
  Real z(int i, int j, int k) const {
    return (s.xz(i + 1, j, k) - s.xz(i, j, k)) * inv_dx + (s.yz(i, j + 1, k) - s.yz(i, j, k)) * inv_dy[j] +
           (s.zz(i, j, k) - s.zz(i, j, k - 1)) * inv_dz;
  }
};

/// The same of a stress that is nothing but shear across the rows: xy and yz.
template <class Stress>
struct ShearDivergence {
  Stress s;
  const Real* inv_dy;
  Real inv_dx, inv_dz;

  ShearDivergence(const Stress& stress, const grid::Grid& g)
      : s(stress), inv_dy(g.inv_dy.data()), inv_dx(Real(1 / g.dx)), inv_dz(Real(1 / g.dz)) {}

  Real x(int i, int j, int k) const { return (s.xy(i, j + 1, k) - s.xy(i, j, k)) * inv_dy[j]; }
  Real y(int i, int j, int k) const {
    return (s.xy(i + 1, j, k) - s.xy(i, j, k)) * inv_dx + (s.yz(i, j, k + 1) - s.yz(i, j, k)) * inv_dz;
  }
  Real z(int i, int j, int k) const { return (s.yz(i, j + 1, k) - s.yz(i, j, k)) * inv_dy[j]; }
};

/// Writes a force to the faces of a box of cells, but for y faces on the lower wall, row 0.
template <class Force>
void assign(const grid::Box& box, const Force& force, grid::VectorField& out) {
  grid::Box above_wall = box;
  above_wall.j0 = std::max(box.j0, 1);
  const auto x = out.x.view(), y = out.y.view(), z = out.z.view();
  grid::for_each_cell(box, [=](int i, int j, int k) { x(i, j, k) = force.x(i, j, k); });
  grid::for_each_cell(above_wall, [=](int i, int j, int k) { y(i, j, k) = force.y(i, j, k); });
  grid::for_each_cell(box, [=](int i, int j, int k) { z(i, j, k) = force.z(i, j, k); });
}

}  // namespace softwall::solid
