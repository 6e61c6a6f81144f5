#pragma once

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::time {

/// Derives what the state does not hold (ghost cells, the elastic force) and must be called once before the
/// first advance() on a state, fresh or read from a checkpoint.
void start(State& state, Setup& setup);

/// One time step of length dt, h / U_b: three Runge-Kutta substeps of solid, momentum, pressure and flow
/// rate.
void advance(State& state, Setup& setup, double dt);

/// The next time step and what limits it. A pure function of case and state.
struct TimeStep {
  double dt;
  const char* limit;  ///< "fixed", "convection", "viscosity", "elastic" or "accuracy"
};
/// convection_rate: of the state's velocity (fluid/stability.hpp).
[[nodiscard]] TimeStep choose_time_step(const State& state, const Setup& setup, double convection_rate);
[[nodiscard]] TimeStep choose_time_step(const State& state, const Setup& setup);

}  // namespace softwall::time
