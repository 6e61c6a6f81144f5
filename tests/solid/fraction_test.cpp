#include "solver/solid/fraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/support/fields.hpp"

// The solid around an edge, from the fractions of the cells that meet there.
namespace softwall::solid {
namespace {

using support::Domain;

class EdgeFraction : public testing::TestWithParam<double> {
 protected:
  Domain d{MPI_COMM_WORLD, {6, 12, 5}, {}, support::faces(12, 2, GetParam())};
  grid::Field phi{d.grid, 1};

  /// The share of each cell above a height.
  void fill_above(double height) {
    support::set_by_index(phi, d.grid, d.grid.ny, [&](int, int j, int) {
      return std::clamp((d.grid.y_face[j + 1] - height) / d.grid.dy[j], 0.0, 1.0);
    });
    fluid::fill_ghosts(phi, d.halo);
  }
  [[nodiscard]] Fraction fraction(bool is_sharp) const {
    return {std::as_const(phi).view(), d.grid.upper_share.data(), is_sharp};
  }
};

/// Wherever a flat surface lies, on an edge it is the share of what lies between the centers.
TEST_P(EdgeFraction, OfASurfaceIsTheShareBetweenTheCenters) {
  const auto& g = d.grid;
  for (double height = g.y_center[3]; height < g.y_center[6]; height += 0.013) {
    fill_above(height);
    for (int j = 2; j < 9; ++j) {
      const double exact = std::clamp((g.y_center[j] - height) / g.dy_face[j], 0.0, 1.0);
      EXPECT_NEAR(fraction(true).edge_xy(2, j, 1), exact, 1e-6) << height << " " << j;
      EXPECT_NEAR(fraction(true).edge_yz(2, j, 1), exact, 1e-6) << height << " " << j;
    }
  }
}

/// A step between two columns: the mean of what each has.
TEST_P(EdgeFraction, IsTheMeanOfBothColumns) {
  support::set_by_index(phi, d.grid, d.grid.ny,
                        [](int i, int j, int) { return j >= (i < 3 ? 5 : 6) ? 1.0 : 0.0; });
  fluid::fill_ghosts(phi, d.halo);
  const int i = 3 - d.grid.x_begin;
  if (i < 1 || i >= d.grid.nx) GTEST_SKIP() << "the step is on another rank";
  EXPECT_NEAR(fraction(true).edge_xy(i, 5, 1), d.grid.upper_share[5] / 2, 1e-6);
  EXPECT_NEAR(fraction(true).edge_xy(i, 6, 1), (1 + d.grid.upper_share[6]) / 2, 1e-6);
}

/// Elsewhere it is the volume-weighted mean of the cells; in full and empty ones both are the same.
TEST_P(EdgeFraction, OfASmearedFractionIsTheMeanOfTheCells) {
  support::set_by_index(phi, d.grid, d.grid.ny,
                        [](int i, int j, int k) { return 0.05 * j + 0.1 * (i % 3) + 0.02 * (k % 2); });
  fluid::fill_ghosts(phi, d.halo);
  const double s = d.grid.upper_share[4];
  const double exact = (s * (phi(2, 4, 1) + phi(1, 4, 1)) + (1 - s) * (phi(2, 3, 1) + phi(1, 3, 1))) / 2;
  EXPECT_NEAR(fraction(false).edge_xy(2, 4, 1), exact, 1e-6);
  for (const double full : {0.0, 1.0}) {
    support::set_by_index(phi, d.grid, d.grid.ny, [=](int, int, int) { return full; });
    fluid::fill_ghosts(phi, d.halo);
    for (const bool is_sharp : {false, true}) {
      EXPECT_NEAR(fraction(is_sharp).edge_xy(2, 4, 1), full, 1e-7);
      EXPECT_NEAR(fraction(is_sharp).edge_yz(2, 4, 1), full, 1e-7);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, EdgeFraction, testing::Values(0.0, 1.0));

}  // namespace
}  // namespace softwall::solid
