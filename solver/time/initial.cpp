#include "solver/time/initial.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "solver/case/wall_normal_grid.hpp"
#include "solver/fluid/forcing.hpp"
#include "solver/grid/cell_loop.hpp"
#include "solver/time/advance.hpp"

namespace softwall::time {

namespace {

/// A number in [-1, 1) from four integers (SplitMix64 finaliser, Steele, Lea & Flood, OOPSLA 2014).
double noise(std::uint64_t seed, std::uint64_t component, std::int64_t cell) {
  std::uint64_t z =
      seed * 0x9e3779b97f4a7c15ULL + component * 0xd1b54a32d192ed03ULL + static_cast<std::uint64_t>(cell);
  for (int round = 0; round < 2; ++round) {
    z += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    z ^= z >> 31;
  }
  return double(z >> 11) * 0x1.0p-52 - 1.0;
}

constexpr double kPi = std::numbers::pi;

/// u of plane Poiseuille flow with bulk velocity 1 in 0 < y < 2; zero in a layer above.
double parabola(double y) { return y < kFluidHeight ? 1.5 * y * (kFluidHeight - y) : 0.0; }

/// Vanishes with its derivative at both walls of the fluid, 1 in the middle.
double envelope(double y) { return y < kFluidHeight ? std::pow(std::sin(kPi * y / 2), 2) : 0.0; }
double envelope_slope(double y) { return y < kFluidHeight ? kPi / 2 * std::sin(kPi * y) : 0.0; }

}  // namespace

State state_at_rest(const Setup& setup) {
  const auto& solid = setup.physics.solid;
  return state_at_rest(setup.grid, solid ? std::optional(solid->formulation) : std::nullopt);
}

State perturbed_laminar(Setup& setup) {
  const auto& g = setup.grid;
  const auto& initial = setup.physics.initial;
  State s = state_at_rest(setup);
  // Vortex pairs about two h wide, the spacing at which lift-up is strong; a weak x modulation makes them
  // wavy.
  const double pairs = std::max(1.0, std::round(g.length_z / 1.5)), beta = 2 * kPi * pairs / g.length_z;
  const double alpha = 2 * kPi / g.length_x, a = initial.amplitude;
  const auto u = s.velocity.x.view(), v = s.velocity.y.view(), w = s.velocity.z.view();
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        const auto cell = (std::int64_t(g.z_begin + k) * g.ny + j) * g.nx_global + g.x_begin + i;
        const double x = (g.x_begin + i + 0.5) * g.dx, z = (g.z_begin + k) * g.dz;
        const double wave = 1 + 0.3 * std::sin(alpha * x), yc = g.y_center[j], yf = g.y_face[j];
        const double roughness = 0.5 * a * envelope(yc);
        u(i, j, k) = parabola(yc) + roughness * noise(initial.seed, 0, cell);
        v(i, j, k) = a * wave * envelope(yf) * std::cos(beta * (z + g.dz / 2)) +
                     roughness * noise(initial.seed, 1, cell);
        w(i, j, k) = -a * wave * envelope_slope(yc) / beta * std::sin(beta * z) +
                     roughness * noise(initial.seed, 2, cell);
      }
    }
  }
  make_solenoidal(s, setup);
  return s;
}

void make_solenoidal(State& s, Setup& setup) {
  fluid::fill_ghosts(s.velocity, setup.walls, setup.halo);
  grid::Field unused(setup.grid, 1);
  setup.projection->project(s.velocity, unused, kRungeKutta3[0], 1.0);
  start(s, setup);
  if (!setup.bulk_velocity) return;
  const auto solid = setup.solid ? setup.solid->input(s.material) : SolidInput{};
  static_cast<void>(
      fluid::hold_flow_rate(s.velocity, solid, *setup.bulk_velocity, setup.grid, setup.decomposition));
  start(s, setup);
}

}  // namespace softwall::time
