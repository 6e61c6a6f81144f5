#include "solver/fluid/walls.hpp"

#include <gtest/gtest.h>

#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"

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

TEST(Walls, ABoxIsClosedOnAllSidesUnderItsLid) {
  time::Setup setup(support::cavity(18, 6), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  grid::VectorField q(g, 1);
  for (grid::Field* f : {&q.x, &q.y, &q.z}) {
    support::set_by_index(*f, g, g.ny, [](int i, int j, int k) { return support::noise(4, i, j, k); });
  }
  fill_ghosts(q, setup.walls, setup.halo);
  const int low = 0, high = g.nx;
  for (int k = -1; k <= g.nz; ++k) {
    for (int j = -1; j <= g.ny; ++j) {
      if (setup.walls.low_x) {
        EXPECT_EQ(q.x(low, j, k), 0);
        EXPECT_EQ(q.y(low - 1, j, k), -q.y(low, j, k));
        EXPECT_EQ(q.z(low - 1, j, k), -q.z(low, j, k));
      }
      if (setup.walls.high_x) {
        EXPECT_EQ(q.x(high, j, k), 0);
        EXPECT_EQ(q.y(high, j, k), -q.y(high - 1, j, k));
        EXPECT_EQ(q.z(high, j, k), -q.z(high - 1, j, k));
      }
    }
    for (int i = setup.walls.low_x ? 1 : 0; i < g.nx; ++i) {
      EXPECT_NEAR(q.x(i, g.ny, k) + q.x(i, g.ny - 1, k), 2, 1e-15) << "the lid moves with u = 1";
      EXPECT_NEAR(q.x(i, -1, k) + q.x(i, 0, k), 0, 1e-15);
      EXPECT_EQ(q.y(i, 0, k), 0);
      EXPECT_EQ(q.y(i, g.ny, k), 0);
    }
  }
  const double walls =
      parallel::sum(setup.decomposition.all(), double(setup.walls.low_x) + double(setup.walls.high_x));
  EXPECT_EQ(walls, 2);
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
