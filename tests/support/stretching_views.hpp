#pragma once

#include "solver/solid/material.hpp"
#include "solver/solid/transported_b/stretching.hpp"
#include "tests/support/linear_flow.hpp"

namespace softwall::support {

/// The stretching kernels' input; phi = 1 serves as the mark of edges in the solid.
inline solid::Stretching stretching(const solid::Material& m, const VectorField& velocity, const Grid& g) {
  const auto all = m.phi.view();
  return solid::stretching_of(m.B, velocity, {all, all, all}, g);
}

/// B the same in every cell, ghost cells too; phi = 1.
inline solid::Material uniform_material(const Grid& g, const double (&B)[3][3]) {
  solid::Material m(g);
  const auto fill = [&](Field& f, double value) {
    set_everywhere(f, g, kCenter, [=](double, double, double) { return value; });
  };
  fill(m.phi, 1);
  fill(m.B.xx, B[0][0]);
  fill(m.B.yy, B[1][1]);
  fill(m.B.zz, B[2][2]);
  fill(m.B.xy, B[0][1]);
  fill(m.B.xz, B[0][2]);
  fill(m.B.yz, B[1][2]);
  return m;
}

}  // namespace softwall::support
