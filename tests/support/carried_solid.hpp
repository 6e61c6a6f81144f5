#pragma once

#include <cmath>

#include "solver/solid/solid.hpp"
#include "solver/solid/transported_b/limiter.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/solid_spec.hpp"

/// phi and B carried and stretched by velocities that are given: no momentum.
namespace softwall::support {

inline SolidSpec carried_spec(WenoWeights weights = WenoWeights::kZ) {
  SolidSpec spec = solid_of(1);
  spec.weno = weights;
  spec.threshold = 0.1;
  spec.min_eigenvalue = 1e-6;
  spec.stiffness = Stiffness::kExplicit;
  return spec;
}

/// Moves the material through time T in n steps; velocity_at(t) gives the field at the start of each substep.
template <class VelocityAt>
void carry(solid::Solid& solid, solid::Material& m, double T, int n, const VelocityAt& velocity_at) {
  const double dt = T / n;
  solid.start(m);
  for (int step = 0; step < n; ++step) {
    double t = step * dt;
    for (const Stage& stage : kRungeKutta3) {
      solid.transport(m, velocity_at(t), stage, dt);
      t += 2 * stage.alpha * dt;
    }
    solid.renew_band(m);
  }
}

/// Largest |det B - 1| at centers, over all ranks.
inline double worst_determinant(const solid::Material& m, const Domain& d) {
  double largest = 0;
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = 0; j < d.grid.ny; ++j) {
      for (int i = 0; i < d.grid.nx; ++i)
        largest = worse(largest, std::abs(solid::tensor_at_center(m.B, i, j, k).determinant() - 1));
    }
  }
  return worst(d.decomposition.all(), largest);
}

}  // namespace softwall::support
