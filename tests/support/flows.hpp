#pragma once

#include <numbers>

#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"

/// Starting states that are far from simple, and ways to compare where they lead.
namespace softwall::support {

/// Smooth, three-dimensional, not symmetric in anything, small at the walls; in an elastic case the layer
/// moves as well. The divergence goes with the first projection.
inline void set_smooth_flow(time::State& s, const time::Setup& setup) {
  const auto& g = setup.grid;
  constexpr double tau = 2 * std::numbers::pi;
  const auto phase = [&](double x, double z) {
    return std::pair(tau * x / g.length_x, tau * z / g.length_z);
  };
  const auto bump = [&](double y) { return std::sin(std::numbers::pi * y / g.height); };
  set_by_position(s.velocity.x, g, kFaceX, [&](double x, double y, double z) {
    const auto [a, c] = phase(x, z);
    return bump(y) * (1.2 + 0.4 * std::sin(a + 0.3) * std::cos(c) + 0.2 * std::cos(2 * c + y));
  });
  set_by_position(s.velocity.y, g, kFaceY, [&](double x, double y, double z) {
    const auto [a, c] = phase(x, z);
    return bump(y) * bump(y) * (0.3 * std::cos(a - c) + 0.2 * std::sin(2 * c + 1));
  });
  set_by_position(s.velocity.z, g, kFaceZ, [&](double x, double y, double z) {
    const auto [a, c] = phase(x, z);
    return bump(y) * (0.3 * std::sin(2 * a + c) + 0.2 * std::cos(c - y));
  });
}

/// A ready state of the case with the smooth flow in it: solenoidal, its flow rate held if the case holds it.
inline time::State smooth_state(time::Setup& setup) {
  time::State s = time::state_at_rest(setup);
  set_smooth_flow(s, setup);
  time::make_solenoidal(s, setup);
  return s;
}

/// A step as long as it may be.
inline void step(time::State& s, time::Setup& setup) {
  time::advance(s, setup, time::choose_time_step(s, setup).dt);
}

/// What a checkpoint would bring back: the rows that are written, everything else zero.
inline time::State reread(time::State& s, const time::Setup& setup) {
  time::State fresh = time::state_at_rest(setup);
  auto from = time::fields_of(s), to = time::fields_of(fresh);
  for (std::size_t n = 0; n < from.size(); ++n) {
    for (int k = 0; k < setup.grid.nz; ++k) {
      for (int j = 0; j < from[n].rows; ++j) {
        for (int i = 0; i < setup.grid.nx; ++i) (*to[n].field)(i, j, k) = (*from[n].field)(i, j, k);
      }
    }
  }
  fresh.time = s.time;
  fresh.step = s.step;
  fresh.driving_gradient = s.driving_gradient;
  return fresh;
}

/// Every number of a state, fields one after another, the same on all ranks.
inline std::vector<std::vector<double>> all_fields(time::State& s, const time::Setup& setup) {
  std::vector<std::vector<double>> values;
  for (const auto& f : time::fields_of(s)) {
    values.push_back(global_values(*f.field, setup.grid, f.rows, setup.decomposition.all()));
  }
  return values;
}

/// The three components of velocity in one row of numbers.
inline std::vector<double> all_velocity(const time::State& s, const time::Setup& setup) {
  std::vector<double> values;
  for (const Field* f : {&s.velocity.x, &s.velocity.y, &s.velocity.z}) {
    const auto part = global_values(*f, setup.grid, setup.grid.ny, setup.decomposition.all());
    values.insert(values.end(), part.begin(), part.end());
  }
  return values;
}

}  // namespace softwall::support
