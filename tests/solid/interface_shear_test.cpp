#include <gtest/gtest.h>

#include "solver/solid/transported_b/limiter.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"
#include "tests/support/physics.hpp"

namespace softwall::time {
namespace {

/// Largest |det B - 1| of the rows that are full of solid.
double largest_determinant_error(const State& s, const grid::Grid& g) {
  double largest = 0;
  for (int k = 0; k < g.nz; ++k) {
    for (int j = g.ny_fluid; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        const double error = std::abs(solid::tensor_at_center(s.material.B, i, j, k).determinant() - 1);
        if (!(error <= largest)) largest = error;  // a NaN counts
      }
    }
  }
  return largest;
}

/// The fluid's shear at the interface never ends, but it does not stretch a layer at rest: with it in the
/// means beside the interface, B_xx of the lowest solid row grew linearly in time, to 4 at t = 5.
TEST(LayerUnderLaminarFlow, IsNotStretchedByTheFluidsShear) {
  Physics p = support::elastic_channel({6, 16, 4, 6});
  p.reynolds = 1;
  p.solid->G = 5;
  p.initial.amplitude = 0;
  time::Setup setup(p, MPI_COMM_WORLD);
  State s = perturbed_laminar(setup);
  while (s.time < 5) advance(s, setup, choose_time_step(s, setup).dt);
  const double shear = 3.0 / 5;  // tau / G with tau = 3 / Re at the wall of a channel of bulk velocity 1
  EXPECT_LT(largest_determinant_error(s, setup.grid), 0.05 * shear * shear);
}

}  // namespace
}  // namespace softwall::time
