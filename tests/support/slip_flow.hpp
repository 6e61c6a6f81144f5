#pragma once

#include "solver/fluid/predictor.hpp"
#include "tests/support/fields.hpp"

namespace softwall::support {

/// The solver's momentum and projection between walls without friction, for exact flows that know no walls.
class SlipFlow {
 public:
  SlipFlow(Domain& domain, double viscosity)
      : velocity(domain.grid, 1),
        pressure(domain.grid, 1),
        domain_(domain),
        predictor_(domain.grid, viscosity),
        projection_(domain.grid, domain.decomposition, domain.halo) {}

  VectorField velocity;
  Field pressure;

  void fill_ghosts() {
    fluid::fill_ghosts(velocity, {}, domain_.halo);
    fluid::fill_ghosts(velocity.x, domain_.halo);  // zero gradient instead of no slip
    fluid::fill_ghosts(velocity.z, domain_.halo);
    fluid::fill_ghosts(pressure, domain_.halo);
  }
  void advance(double dt) {
    for (const Stage& stage : kRungeKutta3) {
      predictor_.advance(velocity, pressure, {}, stage, dt);
      fill_ghosts();
      projection_.project(velocity, pressure, stage, dt);
      fill_ghosts();
    }
  }

 private:
  Domain& domain_;
  fluid::Predictor predictor_;
  pressure::Projection projection_;
};

}  // namespace softwall::support
