#include <gtest/gtest.h>

#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/solids.hpp"

namespace softwall::time {
namespace {

/// Torn cells that are counted in a number of steps too short to mend anything, of a layer with one point
/// that is displaced by three cells.
double counted_in(int steps, Stiffness stiffness) {
  Physics p = support::elastic_channel({12, 12, 8, 9});
  SolidSpec spec = support::made_of(*p.solid, 1, 1);
  spec.formulation = SolidFormulation::kReferenceMap;
  spec.stiffness = stiffness;
  p.solid = spec;
  Setup setup(p, MPI_COMM_WORLD);
  State s = state_at_rest(setup);
  const auto& g = setup.grid;
  const int row = g.ny_fluid + 4;
  support::set_by_index(s.material.displacement.y, g, g.ny, [&](int i, int j, int k) {
    return i == 3 && j == row && k == 4 ? 3 * g.dy.exact()[row] : 0.0;
  });
  start(s, setup);
  for (int step = 0; step < steps; ++step) advance(s, setup, 1e-9);
  return parallel::sum(setup.decomposition.all(), double(setup.solid->limited_cells()));
}

/// However often a scheme finds the strain within a step.
TEST(LimitedCells, CountOnceAStep) {
  const double in_a_step = counted_in(1, Stiffness::kImplicit);
  EXPECT_GT(in_a_step, 0);
  EXPECT_EQ(counted_in(3, Stiffness::kImplicit), 3 * in_a_step);
  EXPECT_EQ(counted_in(1, Stiffness::kExplicit), in_a_step);
}

}  // namespace
}  // namespace softwall::time
