#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "tests/support/physics.hpp"

/// The solids that verification runs through, both formulations and of transported B the paper's transport of
/// phi and the default one: every one has to pass the same tests.
namespace softwall::support {

struct NamedSolid {
  std::string name;
  SolidSpec spec;
  friend void PrintTo(const NamedSolid& solid, std::ostream* out) { *out << solid.name; }
};

inline std::vector<NamedSolid> solids() {
  const Physics paper = elastic_channel({3, 4, 4, 3});
  std::vector<NamedSolid> all;
  for (const auto formulation : kBothFormulations)
    all.push_back({name_of(formulation), *formulated(paper, formulation).solid});
  all.push_back({"TransportedBUnderAHeight", all.front().spec});
  all.back().spec.interface = InterfaceTransport::kHeight;
  return all;
}

inline std::string solid_name(const testing::TestParamInfo<NamedSolid>& info) { return info.param.name; }

/// The same solid with another modulus and viscosity.
inline SolidSpec made_of(SolidSpec spec, double G, double viscosity_ratio) {
  spec.G = G;
  spec.viscosity_ratio = viscosity_ratio;
  return spec;
}

/// Deforms the rows from first_row on by a shear that depends on y alone, a displacement xi(y) in x with
/// dxi/dy = gamma(y): B_xy = gamma, B_xx = 1 + gamma^2. Below them the displacement goes on
/// in a straight line.
template <class Displacement, class Gamma>
void shear_material(solid::Material& m, const grid::Grid& g, int first_row, const Displacement& xi,
                    const Gamma& gamma) {
  const auto x = m.displacement.x.view();
  const double surface = g.y_face[first_row];
  grid::for_each_cell(grid::all_cells(g), [&](int i, int j, int k) {
    const double y = g.y_center[j];
    x(i, j, k) = y > surface ? xi(y) : xi(surface) + gamma(surface) * (y - surface);
  });
  const auto xx = m.B.xx.view(), xy = m.B.xy.view();
  grid::for_each_cell(grid::rows(g, first_row, g.ny + 1), [&](int i, int j, int k) {
    xy(i, j, k) = gamma(g.y_face[j]);
    if (j < g.ny) xx(i, j, k) = 1 + gamma(g.y_center[j]) * gamma(g.y_center[j]);
  });
}

}  // namespace softwall::support
