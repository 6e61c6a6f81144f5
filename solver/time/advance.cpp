#include "solver/time/advance.hpp"

#include "solver/fluid/forcing.hpp"
#include "solver/fluid/stability.hpp"

namespace softwall::time {

namespace {

SolidInput solid_input(const State& s, const Setup& setup) {
  return setup.solid ? setup.solid->input(s.material) : SolidInput{};
}

}  // namespace

void start(State& s, Setup& setup) {
  fluid::fill_ghosts(s.velocity, setup.walls, setup.halo);
  fluid::fill_ghosts(s.pressure, setup.halo);
  if (setup.solid) setup.solid->start(s.material);
}

// Equation numbers refer to solver/README.md.
void advance(State& s, Setup& setup, double dt) {
  double driven = 0;
  for (const Stage& stage : kRungeKutta3) {
    if (setup.solid) setup.solid->transport(s.material, s.velocity, stage, dt);         // phi, B     (6)-(7)
    setup.predictor.advance(s.velocity, s.pressure, solid_input(s, setup), stage, dt);  // u*         (8)
    setup.projection.project(s.velocity, s.pressure, stage, dt);  // u, p       (9)-(11)
    if (setup.bulk_velocity) {                                    // flow rate  (12)
      driven += fluid::hold_flow_rate(s.velocity, solid_input(s, setup), *setup.bulk_velocity, setup.grid,
                                      setup.decomposition);
    }
    fluid::fill_ghosts(s.velocity, setup.walls, setup.halo);
  }
  if (setup.solid) setup.solid->renew_band(s.material);
  s.driving_gradient = driven / dt;
  s.time += dt;
  ++s.step;
}

TimeStep choose_time_step(const State& s, const Setup& setup) {
  const auto& spec = setup.physics.time_step;
  if (spec.fixed_dt) return {*spec.fixed_dt, "fixed"};
  TimeStep step{fluid::convection_limit(s.velocity, setup.grid, setup.decomposition), "convection"};
  const auto restrict_to = [&](double limit, const char* name) {
    if (limit < step.dt) step = {limit, name};
  };
  restrict_to(fluid::viscosity_limit(setup.viscosity, solid_input(s, setup), setup.grid), "viscosity");
  if (setup.solid) restrict_to(setup.solid->elastic_limit(s.material), "elastic");
  step.dt *= spec.safety;
  return step;
}

}  // namespace softwall::time
