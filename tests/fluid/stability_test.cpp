#include "solver/fluid/stability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/case/step_limits.hpp"
#include "tests/support/fields.hpp"

namespace softwall::fluid {
namespace {

using support::Domain;

TEST(Stability, ConvectionFollowsTheFastestCellOfAllRanks) {
  Domain d(MPI_COMM_WORLD, {12, 6, 7}, {}, support::faces(6, 2, 1.5));
  const auto& g = d.grid;
  grid::VectorField velocity(g, 1);
  EXPECT_EQ(step_limits::convection(convection_rate(velocity, g, d.decomposition)), HUGE_VAL);
  // Noise of at most 1 everywhere, and one cell on the last rank that outruns it.
  velocity = support::random_velocity(d, 3);
  support::set_by_index(velocity.x, g, g.ny,
                        [](int i, int j, int k) { return i == 11 && j == 2 && k == 6 ? -300.0 : 0; });
  support::set_by_index(velocity.y, g, g.ny,
                        [](int i, int j, int k) { return i == 11 && j == 3 && k == 6 ? 200.0 : 0; });
  support::set_by_index(velocity.z, g, g.ny,
                        [](int i, int j, int k) { return i == 11 && j == 2 && k == 6 ? 100.0 : 0; });
  const double rate = 300 / g.dx + 200 / g.dy[2] + 100 / g.dz;
  const double found = convection_rate(velocity, g, d.decomposition);
  EXPECT_NEAR(step_limits::convection(found), std::numbers::sqrt3 / rate, 1e-15);
}

TEST(Stability, AVelocityThatIsNoNumberIsInfinitelyFast) {
  Domain d(MPI_COMM_WORLD, {12, 6, 7}, {}, support::faces(6, 2, 1.5));
  for (grid::Field grid::VectorField::*component :
       {&grid::VectorField::x, &grid::VectorField::y, &grid::VectorField::z}) {
    for (const double poison : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      grid::VectorField velocity = support::random_velocity(d, 3);
      (velocity.*component)(2, 3, 1) = Real(poison);
      EXPECT_EQ(convection_rate_here(velocity, d.grid), HUGE_VAL);
    }
  }
}

TEST(Stability, ViscosityFollowsTheSmallestCellAndTheSolid) {
  const Domain d(MPI_COMM_WORLD, {12, 6, 7}, {}, support::faces(6, 2, 1.5));
  const auto& g = d.grid;
  const auto limit = [&](double nu, int row) {
    return 2.51 / (4 * nu * (1 / (g.dx * g.dx) + 1 / (g.dy[row] * g.dy[row]) + 1 / (g.dz * g.dz)));
  };
  EXPECT_NEAR(viscosity_limit(0.01, {}, g), limit(0.01, 0), 1e-12);
  const grid::Field phi(g, 1);
  const grid::VectorField force(g, 0);
  EXPECT_NEAR(viscosity_limit(0.01, {&phi, &force, &force, 4, 10, 10}, g), limit(0.1, 5), 1e-12);
  // Where the solid's is implicit between rows, it counts along them alone.
  const double along = 10 / (g.dx * g.dx) + 10 / (g.dz * g.dz);
  EXPECT_NEAR(viscosity_limit(0.01, {&phi, &force, &force, 4, 10, 1}, g),
              2.51 / (4 * 0.01 * (along + 1 / (g.dy[5] * g.dy[5]))), 1e-12);
  EXPECT_NEAR(viscosity_limit(0.01, {&phi, &force, &force, 4, 0.1, 0.1}, g), limit(0.01, 0),
              1e-12);  // fluid lives there too
}

}  // namespace
}  // namespace softwall::fluid
