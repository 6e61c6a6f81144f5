#include "solver/fluid/walls.hpp"

#include <gtest/gtest.h>

#include "tests/support/fields.hpp"

namespace softwall::fluid {
namespace {

using support::Domain;

TEST(Walls, MeanOfGhostAndFirstRowIsTheWall) {
  Domain d(MPI_COMM_WORLD, {12, 6, 7}, {}, support::faces(6));
  auto velocity = support::random_velocity(d, 3);
  fill_ghosts(velocity, {.bottom_u = -0.3, .top_u = 2}, d.halo);
  const auto& g = d.grid;
  for (int k = -1; k <= g.nz; ++k) {  // ghost columns too: their rows come from the neighbours
    for (int i = -1; i <= g.nx; ++i) {
      EXPECT_NEAR(velocity.x(i, -1, k) + velocity.x(i, 0, k), 2 * -0.3, 1e-15);
      EXPECT_NEAR(velocity.x(i, g.ny, k) + velocity.x(i, g.ny - 1, k), 2 * 2.0, 1e-14);
      EXPECT_NEAR(velocity.z(i, -1, k) + velocity.z(i, 0, k), 0, 1e-15);
      EXPECT_NEAR(velocity.z(i, g.ny, k) + velocity.z(i, g.ny - 1, k), 0, 1e-15);
      EXPECT_EQ(velocity.y(i, 0, k), 0);
      EXPECT_EQ(velocity.y(i, g.ny, k), 0);
    }
  }
}

TEST(Walls, PressureHasNoGradientThere) {
  Domain d(MPI_COMM_WORLD, {12, 6, 7}, {}, support::faces(6));
  const auto& g = d.grid;
  grid::Field p(g, 1);
  support::set_by_index(p, g, g.ny, [](int i, int j, int k) { return support::noise(1, i, j, k); });
  fill_ghosts(p, d.halo);
  for (int k = -1; k <= g.nz; ++k) {
    for (int i = -1; i <= g.nx; ++i) {
      EXPECT_EQ(p(i, -1, k), p(i, 0, k));
      EXPECT_EQ(p(i, g.ny, k), p(i, g.ny - 1, k));
    }
  }
}

}  // namespace
}  // namespace softwall::fluid
