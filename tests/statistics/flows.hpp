#pragma once

#include <cmath>
#include <numbers>

#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"
#include "solver/time/setup.hpp"
#include "tests/support/solid_spec.hpp"

/// Small cases and fields for the tests of this folder. 8 x 6 columns: four ranks split them in x and z.
namespace softwall::statistics::testing {

constexpr double kPi = std::numbers::pi;

inline Physics rigid_case() {
  Physics p;
  p.flow = FlowType::kRigidChannel;
  p.reynolds = 100;
  p.length_x = 4;
  p.length_z = 3;
  p.layer_height = 0.5;
  p.grid = {.nx = 8, .ny_fluid = 16, .ny_solid = 0, .nz = 6, .stretching = 1.5};
  p.time_step.safety = 0.5;
  p.initial.amplitude = 0.1;
  p.initial.seed = 7;
  p.statistics = {.start_time = 0, .interval_steps = 1, .block_length = 1};
  return p;
}

inline Physics elastic_case() {
  Physics p = rigid_case();
  p.flow = FlowType::kElasticWall;
  p.grid.ny_solid = 4;
  p.grid.stretching = 0;
  p.solid = support::solid_of(2);
  p.solid->viscosity_ratio = 3;
  p.solid->stiffness = Stiffness::kExplicit;
  return p;
}

/// Samples from some moment on, into short blocks.
inline Physics scheduled(Physics p) {
  p.time_step.fixed_dt = 0.003;
  p.statistics = {.start_time = 0.01, .interval_steps = 4, .block_length = 0.02};
  return p;
}

/// Advances a disturbed flow by `steps` and lets `after_step` see each.
template <class AfterStep>
void advance_disturbed(time::Setup& setup, int steps, const AfterStep& after_step) {
  auto s = time::perturbed_laminar(setup);
  for (int n = 0; n < steps; ++n) {
    const double dt = time::choose_time_step(s, setup).dt;
    time::advance(s, setup, dt);
    after_step(s, dt);
  }
}

/// Calls set(i, j, k, x, z) for all columns, rows j0 <= j < j1; x, z is the low corner of the cell.
template <class Set>
void for_columns(const grid::Grid& g, int j0, int j1, const Set& set) {
  for (int k = 0; k < g.nz; ++k) {
    for (int j = j0; j < j1; ++j) {
      for (int i = 0; i < g.nx; ++i) set(i, j, k, (g.x_begin + i) * g.dx, (g.z_begin + k) * g.dz);
    }
  }
}

/// A fixed number in [-1, 1) for each cell of the whole box.
inline double noise(const grid::Grid& g, int i, int j, int k, int component) {
  const double n = ((g.z_begin + k) * 100.0 + j) * g.nx_global + g.x_begin + i + 0.37 * component;
  const double s = std::sin(12.9898 * n + 78.233 * component) * 43758.5453;
  return 2 * (s - std::floor(s)) - 1;
}

/// Velocity, pressure and, with an elastic wall, phi and B without any symmetry or smoothness.
inline time::State rough_state(time::Setup& setup) {
  const auto& g = setup.grid;
  auto s = time::state_at_rest(setup);
  for_columns(g, 0, g.ny, [&](int i, int j, int k, double, double) {
    s.velocity.x(i, j, k) = 1 + noise(g, i, j, k, 0);
    s.velocity.y(i, j, k) = noise(g, i, j, k, 1);
    s.velocity.z(i, j, k) = noise(g, i, j, k, 2);
    s.pressure(i, j, k) = 2 + noise(g, i, j, k, 3);
    if (!s.elastic) return;
    auto& m = s.material;
    const bool in_band = j >= g.ny_fluid - 2;
    m.phi(i, j, k) = in_band ? 0.5 + 0.5 * noise(g, i, j, k, 4) : 0;
    m.B.xx(i, j, k) = in_band ? 2 + 0.2 * noise(g, i, j, k, 5) : 0;
    m.B.yy(i, j, k) = in_band ? 1 + 0.2 * noise(g, i, j, k, 6) : 0;
    m.B.zz(i, j, k) = in_band ? 1 + 0.2 * noise(g, i, j, k, 7) : 0;
    m.B.xy(i, j, k) = in_band ? 0.3 * noise(g, i, j, k, 8) : 0;
  });
  time::start(s, setup);
  return s;
}

}  // namespace softwall::statistics::testing
