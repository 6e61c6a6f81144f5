#pragma once

#include "solver/time/setup.hpp"
#include "tests/support/solid_spec.hpp"

/// Small cases, built by hand.
namespace softwall::support {

struct Cells {
  int nx, ny_fluid, ny_solid, nz;
};

/// 0 < y < 2 between rigid walls, 3 x 1.5 wide, Re = 100, uniform.
inline Physics rigid_channel(Cells n) {
  Physics p;
  p.flow = FlowType::kRigidChannel;
  p.reynolds = 100;
  p.length_x = 3;
  p.length_z = 1.5;
  p.grid.nx = n.nx;
  p.grid.ny_fluid = n.ny_fluid;
  p.grid.ny_solid = n.ny_solid;
  p.grid.nz = n.nz;
  p.time_step.safety = 0.8;
  p.initial.amplitude = 0.3;
  p.initial.seed = 7;
  return p;
}

/// The same under an elastic layer of ny_solid rows, G = 1, with the schema's threshold and floor.
inline Physics elastic_channel(Cells n) {
  Physics p = rigid_channel(n);
  p.flow = FlowType::kElasticWall;
  p.layer_height = 2.0 * n.ny_solid / n.ny_fluid;
  p.solid = solid_of(1);
  return p;
}

/// A slow wave at the interface of a fluid 2 deep and a layer 1 thick, viscosity 0.02 in both, G = 1, one
/// in 2.
inline Physics interface_wave(Cells n) {
  Physics p = elastic_channel(n);
  p.flow = FlowType::kInterfaceWave;
  p.reynolds = 50;
  p.length_x = p.length_z = 2;
  p.layer_height = 1;
  p.wave = WaveSpec{.decay = 0.2198688982, .frequency = 2.883976853, .displacement = 1e-4};
  return p;
}

/// A box that the solid fills from wall to wall (0 < y < 2), undeformed: for the material's own dynamics.
inline Physics solid_box(Cells n) {
  Physics p = elastic_channel({n.nx, n.ny_fluid, 0, n.nz});
  p.layer_height = 0;
  return p;
}

/// A square cavity of nx x ny cells with a moving lid, Re = 100, fluid alone.
inline Physics cavity(int nx, int ny) {
  Physics p;
  p.flow = FlowType::kCavity;
  p.reynolds = 100;
  p.length_x = p.length_z = p.height = 1;
  p.grid = {.nx = nx, .ny_fluid = ny, .ny_solid = 0, .nz = 1, .stretching = 0};
  p.time_step.safety = 0.8;
  return p;
}

/// The same with a soft disc near the lid, which begins to move at once.
inline Physics cavity_with_disc(int nx, int ny) {
  Physics p = cavity(nx, ny);
  p.solid = solid_of(0.1);
  p.solid->threshold = 0.5;
  p.solid->extension = Extension::kNormal;
  p.solid->disc = DiscSpec{.x = 0.6, .y = 0.65, .radius = 0.2};
  return p;
}

/// The same case with the solid in another formulation.
inline Physics formulated(Physics p, SolidFormulation formulation) {
  p.solid->formulation = formulation;
  return p;
}

inline constexpr SolidFormulation kBothFormulations[] = {SolidFormulation::kTransportedB,
                                                         SolidFormulation::kReferenceMap};
inline const char* name_of(SolidFormulation formulation) {
  return formulation == SolidFormulation::kTransportedB ? "TransportedB" : "ReferenceMap";
}

/// phi = 1 and B = identity everywhere; d = 0 and a surface on the lower wall.
inline solid::Material solid_everywhere(const grid::Grid& g,
                                        SolidFormulation formulation = SolidFormulation::kTransportedB) {
  solid::Material m(g);
  m.formulation = formulation;
  m.surface_at_rest = g.y_face[0];
  for (grid::Field* one : {&m.phi, &m.B.xx, &m.B.yy, &m.B.zz}) {
    const auto q = one->view();
    grid::for_each_cell(grid::all_cells(g), [=](int i, int j, int k) { q(i, j, k) = 1; });
  }
  return m;
}

}  // namespace softwall::support
