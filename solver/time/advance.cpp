#include "solver/time/advance.hpp"

#include "solver/case/step_limits.hpp"
#include "solver/fluid/forcing.hpp"
#include "solver/fluid/stability.hpp"
#include "solver/time/poison.hpp"

namespace softwall::time {

using parallel::Phase;

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

namespace {

/// u* from u^ where the solid's stress between rows is implicit, (18) of solver/solid/README.md.
void apply_implicit_stress(State& s, Setup& setup, const Stage& stage, double dt) {
  if (!setup.solid) return;
  setup.solid->apply_implicit_stress(
      s.material, setup.predictor.velocity_before(),
      {dt, stage.alpha * dt * setup.viscosity, 2 * stage.alpha * dt * s.driving_gradient}, s.velocity);
}

/// The substeps of a closed box: no driving; a prescribed velocity only carries the solid.
void advance_closed_box(State& s, Setup& setup, double dt) {
  auto& profile = setup.profile;
  auto& viscosity = setup.implicit_viscosity;
  for (const Stage& stage : kRungeKutta3) {
    if (setup.solid) setup.solid->transport(s.material, s.velocity, stage, dt);
    if (setup.velocity_prescribed) continue;
    profile.time(Phase::kMomentum, [&] {
      if (viscosity) viscosity->keep(s.velocity, stage, dt);
      setup.predictor.advance(s.velocity, s.pressure, solid_input(s, setup), stage, dt);
      if (viscosity) viscosity->apply(s.velocity, stage, dt);
      apply_implicit_stress(s, setup, stage, dt);
    });
    fluid::fill_ghosts(s.velocity, setup.walls, setup.halo);
    profile.time(Phase::kPoisson, [&] { setup.box_projection->project(s.velocity, s.pressure, stage, dt); });
    fluid::fill_ghosts(s.velocity, setup.walls, setup.halo);
    fluid::fill_ghosts(s.pressure, setup.halo);
  }
}

/// u, p (9)-(12); returns what was added to hold the flow rate.
double project_and_drive(State& s, Setup& setup, const Stage& stage, double dt) {
  auto& projection = *setup.projection;
  const double duration = 2 * stage.alpha * dt;
  projection.find_psi(s.velocity, duration);
  double push = 0;
  if (setup.bulk_velocity) {
    const parallel::Profile::Scope scope(&setup.profile, Phase::kCorrection);
    push = fluid::flow_rate_correction({s.velocity.x, projection.psi(), duration, projection.row_sums()},
                                       solid_input(s, setup), *setup.bulk_velocity, setup.grid,
                                       setup.decomposition);
  }
  projection.correct(s.velocity, s.pressure, duration, push);
  return push;
}

/// The substeps of a channel; returns the sum of what drives it. Equation numbers refer to solver/README.md.
double advance_channel(State& s, Setup& setup, double dt) {
  auto& profile = setup.profile;
  double driven = 0;
  for (const Stage& stage : kRungeKutta3) {
    profile.time(Phase::kTransport, [&] {  // phi, B (6)-(7)
      if (setup.solid) setup.solid->transport(s.material, s.velocity, stage, dt);
    });
    profile.time(Phase::kMomentum, [&] {  // u* (8)
      setup.predictor.advance(s.velocity, s.pressure, solid_input(s, setup), stage, dt);
      apply_implicit_stress(s, setup, stage, dt);
    });
    if constexpr (kPoisonsGhosts) poison_ghosts(s.velocity);
    driven += project_and_drive(s, setup, stage, dt);
    if constexpr (kPoisonsGhosts) poison_unread_ghosts(s.pressure);
    profile.time(Phase::kHalo, [&] { fluid::fill_other_ghosts(s.velocity, setup.walls, setup.halo); });
  }
  return driven;
}

}  // namespace

void advance(State& s, Setup& setup, double dt) {
  double driven = 0;
  if (is_closed_box(setup.physics.flow)) {
    advance_closed_box(s, setup, dt);
  } else {
    driven = advance_channel(s, setup, dt);
  }
  if (setup.solid) setup.solid->renew_band(s.material);
  s.driving_gradient = driven / dt;
  s.time += dt;
  ++s.step;
}

TimeStep choose_time_step(const State& s, const Setup& setup, double convection_rate) {
  const parallel::Profile::Scope scope(&setup.profile, Phase::kTimeStep);
  const auto& spec = setup.physics.time_step;
  if (spec.fixed_dt) return {*spec.fixed_dt, "fixed"};
  TimeStep step{step_limits::convection(convection_rate), "convection"};
  const auto restrict_to = [&](double limit, const char* name) {
    if (limit < step.dt) step = {limit, name};
  };
  if (!setup.velocity_prescribed) {
    restrict_to(fluid::moving_wall_limit(setup.walls, setup.grid), "convection");
    if (!setup.implicit_viscosity)
      restrict_to(fluid::viscosity_limit(setup.viscosity, solid_input(s, setup), setup.grid), "viscosity");
    if (setup.solid) restrict_to(setup.solid->elastic_limit(s.material), "elastic");
  }
  step.dt *= spec.safety;
  const auto& solid = setup.physics.solid;
  if (solid && is_driven_channel(setup.physics.flow))
    restrict_to(step_limits::accuracy(solid->dt_plus, setup.viscosity, s.driving_gradient), "accuracy");
  return step;
}

TimeStep choose_time_step(const State& s, const Setup& setup) {
  const double rate = setup.profile.time(
      Phase::kTimeStep, [&] { return fluid::convection_rate(s.velocity, setup.grid, setup.decomposition); });
  return choose_time_step(s, setup, rate);
}

}  // namespace softwall::time
