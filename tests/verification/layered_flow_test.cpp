#include <gtest/gtest.h>

#include "solver/time/advance.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/order.hpp"
#include "tests/support/physics.hpp"

// Laminar Poiseuille flow under an elastic layer: at rest in the end, sheared by the flow and by the
// gradient,
//   0 < y < 2: u = 3/2 y (2 - y), P = 3 / Re;  2 < y: u = 0, B_xy = P (1 - y) / G, B_xx = 1 + B_xy^2.
namespace softwall::time {
namespace {

struct Errors {
  double velocity, shear, stretch;
};

Errors run_to_rest(int ny_fluid) {
  Physics p = support::elastic_channel({3, ny_fluid, ny_fluid / 4, 3 * support::world_size()});
  p.reynolds = 5;
  time::Setup setup(p, MPI_COMM_WORLD);
  const double P = 3 / p.reynolds, G = p.solid->G;
  const auto& g = setup.grid;
  State s = state_at_rest(g, true);
  start(s, setup);
  while (s.time < 40) advance(s, setup, choose_time_step(s, setup).dt);
  const auto u = [](double, double y, double) { return y < 2 ? 1.5 * y * (2 - y) : 0; };
  Errors errors{support::largest_error(s.velocity.x, g, support::kFaceX, setup.decomposition, u), 0, 0};
  for (int j = g.ny_fluid + 1; j < g.ny; ++j) {  // edges and centers inside the solid
    const double shear = P * (1 - g.y_face[j]) / G, at_center = P * (1 - g.y_center[j]) / G;
    errors.shear = support::worse(errors.shear, std::abs(s.material.B.xy(0, j, 0) - shear));
    errors.stretch =
        support::worse(errors.stretch, std::abs(s.material.B.xx(0, j, 0) - 1 - at_center * at_center));
  }
  return errors;
}

TEST(PoiseuilleUnderALayer, ComesToTheExactRest) {
  const Errors coarse = run_to_rest(8), middle = run_to_rest(16), fine = run_to_rest(32);
  EXPECT_GT(support::observed_order(coarse.velocity, middle.velocity), 0.9);
  EXPECT_GT(support::observed_order(middle.velocity, fine.velocity), 0.9)
      << middle.velocity << ' ' << fine.velocity;
  EXPECT_GT(support::observed_order(middle.shear, fine.shear), 0.9) << middle.shear << ' ' << fine.shear;
  EXPECT_GT(support::observed_order(middle.stretch, fine.stretch), 0.9)
      << middle.stretch << ' ' << fine.stretch;
  EXPECT_LT(fine.velocity, 0.02);
  EXPECT_LT(fine.shear, 0.02);
}

}  // namespace
}  // namespace softwall::time
