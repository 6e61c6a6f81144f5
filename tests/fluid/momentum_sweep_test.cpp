#include "solver/fluid/momentum_sweep.hpp"

#include <gtest/gtest.h>

#include "tests/support/fields.hpp"
#include "tests/support/momentum_at_a_point.hpp"

// The sweep remembers fluxes from cell to cell; it must find what the kernels find in each cell alone.
namespace softwall::fluid {
namespace {

using support::Domain;

void expect_the_kernels_values(Domain& d, const MomentumInput& m, int j0, int j1) {
  const auto& g = d.grid;
  MomentumSweep sweep(g);
  int rows = 0;
  double worst = 0, largest = 0;
  sweep.for_each_row(m, j0, j1, [&](int j, int k, const MomentumRow& now) {
    ++rows;
    ASSERT_TRUE(j0 <= j && j < j1 && 0 <= k && k < g.nz);
    for (int i = 0; i < g.nx; ++i) {
      worst = support::worse(worst, std::abs(now.x[i] - momentum_x(m, i, j, k)));
      worst = support::worse(worst, std::abs(now.z[i] - momentum_z(m, i, j, k)));
      if (j > 0) worst = support::worse(worst, std::abs(now.y[i] - momentum_y(m, i, j, k)));
      largest = support::worse(largest, std::abs(double(now.x[i])));
    }
  });
  EXPECT_EQ(rows, (j1 - j0) * g.nz);
  EXPECT_GT(largest, 0.1);
  EXPECT_LT(worst, 1e-12 * largest);
}

TEST(MomentumSweep, FindsWhatTheKernelsFindInEachCell) {
  // More rows than the sweep does at once, and widths that are no multiple of a vector.
  for (const Domain::Size& n : {Domain::Size{9, 53, 4}, {16, 24, 3}, {5, 4, 5}}) {
    Domain d(MPI_COMM_WORLD, n, {}, support::faces(n.ny, 2, 1.4));
    const auto velocity = support::random_velocity(d, 7);
    const auto m = momentum_input(velocity, d.grid, 0.01);
    for (const int j0 : {0, 2}) expect_the_kernels_values(d, m, j0, n.ny);
  }
}

}  // namespace
}  // namespace softwall::fluid
