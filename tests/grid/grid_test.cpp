#include "solver/grid/grid.hpp"

#include <gtest/gtest.h>

#include "tests/support/domain.hpp"
#include "tests/support/physics.hpp"

namespace softwall::grid {
namespace {

constexpr int kGhost = RowArray::kGhost;

/// Every relation between the row arrays that the kernels rely on.
void expect_consistent(const Grid& g) {
  double sum = 0;
  for (int j = 0; j < g.ny; ++j) sum += g.dy[j];
  EXPECT_NEAR(sum, g.height, 1e-14 * g.height);
  for (int j = -kGhost; j < g.ny + kGhost; ++j) {
    EXPECT_GT(g.dy[j], 0);
    EXPECT_DOUBLE_EQ(g.dy[j], g.y_face[j + 1] - g.y_face[j]);
    EXPECT_DOUBLE_EQ(g.y_center[j], (g.y_face[j] + g.y_face[j + 1]) / 2);
    EXPECT_DOUBLE_EQ(g.inv_dy[j] * g.dy[j], 1);
  }
  for (int j = -kGhost + 1; j < g.ny + kGhost; ++j) {
    EXPECT_DOUBLE_EQ(g.dy_face[j], g.y_center[j] - g.y_center[j - 1]);
    EXPECT_NEAR(g.dy_face[j], (g.dy[j] + g.dy[j - 1]) / 2, 1e-14);
    EXPECT_DOUBLE_EQ(g.inv_dy_face[j] * g.dy_face[j], 1);
    EXPECT_DOUBLE_EQ(g.upper_share[j], g.dy[j] / (g.dy[j] + g.dy[j - 1]));
  }
}

void expect_mirrored(const Grid& g) {
  const double bottom = g.y_face[0], top = g.y_face[g.ny];
  for (int j = 1; j <= kGhost; ++j) {
    EXPECT_NEAR(bottom - g.y_face[-j], g.y_face[j] - bottom, 1e-15);
    EXPECT_NEAR(g.y_face[g.ny + j] - top, top - g.y_face[g.ny - j], 1e-15);
    EXPECT_NEAR(g.dy[-j], g.dy[j - 1], 1e-15);
    EXPECT_NEAR(g.dy[g.ny - 1 + j], g.dy[g.ny - j], 1e-15);
  }
  EXPECT_NEAR(g.upper_share[0], 0.5, 1e-14);
  EXPECT_NEAR(g.upper_share[g.ny], 0.5, 1e-14);
}

TEST(Grid, RowsAreConsistentUniformAndStretched) {
  for (const double stretching : {0.0, 1.5, 2.5}) {
    const support::Domain d(MPI_COMM_WORLD, {12, 16, 9}, {}, support::faces(16, 2, stretching));
    expect_consistent(d.grid);
    expect_mirrored(d.grid);
    EXPECT_EQ(d.grid.ny, 16);
    EXPECT_EQ(d.grid.ny_fluid, 16);
  }
}

TEST(Grid, FollowsTheCase) {
  for (const double stretching : {0.0, 1.2}) {
    Physics p = support::elastic_channel({12, 16, 4, 9});
    p.grid.stretching = stretching;
    const parallel::Decomposition decomposition(MPI_COMM_WORLD, 12, 9);
    const Grid g = make_grid(p, decomposition);
    expect_consistent(g);
    expect_mirrored(g);
    EXPECT_EQ(g.ny, 20);
    EXPECT_EQ(g.ny_fluid, 16);
    EXPECT_DOUBLE_EQ(g.y_face[g.ny_fluid], 2);
    EXPECT_DOUBLE_EQ(g.height, 2.5);
    EXPECT_DOUBLE_EQ(g.dx, 3.0 / 12);
    EXPECT_DOUBLE_EQ(g.dz, 1.5 / 9);
    EXPECT_EQ(g.nx, decomposition.x().size());
    EXPECT_EQ(g.nz, decomposition.z().size());
    EXPECT_EQ(g.x_begin, decomposition.x().begin);
    EXPECT_EQ(g.z_begin, decomposition.z().begin);
    EXPECT_DOUBLE_EQ(g.cells(), 12.0 * 20 * 9);
  }
}

}  // namespace
}  // namespace softwall::grid
