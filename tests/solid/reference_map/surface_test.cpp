#include "solver/solid/reference_map/surface.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/solid/reference_map/extrapolation.hpp"
#include "tests/support/fields.hpp"

namespace softwall::solid::reference_map {
namespace {

using support::Domain;

constexpr double kAtRest = 1.2, kTau = 2 * std::numbers::pi;

/// d_y of a layer whose surface is at eta(x, z), falling linearly to zero on the wall at y = 2.
template <class Eta>
grid::VectorField raised(Domain& d, const Eta& eta) {
  grid::VectorField displacement(d.grid, 3);
  const double height = d.grid.height;
  support::set_by_position(displacement.y, d.grid, support::kFaceY, [=](double x, double y, double z) {
    return (eta(x, z) - kAtRest) * (height - y) / (height - eta(x, z));
  });
  d.halo.fill({&displacement.y}, {0, d.grid.ny + 1});
  return displacement;
}

/// Heights of a surface that rises and falls along x and z.
class WavyHeights : public testing::Test {
 protected:
  Domain d{MPI_COMM_WORLD, {9, 16, 8}, {}, support::faces(16, 2, 1.0)};
  Heights heights{d.grid, 2};

  WavyHeights() { heights.find(raised(d, eta).y, kAtRest); }
  static double eta(double x, double z) { return kAtRest + 0.2 * std::sin(kTau * x / 3 + kTau * z / 1.5); }
  double eta_over(int i, int k) const {
    return eta((d.grid.x_begin + i + 0.5) * d.grid.dx, (d.grid.z_begin + k + 0.5) * d.grid.dz);
  }
};

TEST_F(WavyHeights, OfALinearDisplacementAreExact) {
  double lowest = 2;
  for (int k = -2; k < d.grid.nz + 2; ++k) {
    for (int i = -2; i < d.grid.nx + 2; ++i) {
      EXPECT_NEAR(heights(i, k), eta_over(i, k), 1e-13);
      const bool own = i >= 0 && i < d.grid.nx && k >= 0 && k < d.grid.nz;
      if (own) lowest = std::min(lowest, heights(i, k));
    }
  }
  EXPECT_EQ(heights.lowest(), lowest);
}

TEST_F(WavyHeights, AreAsFlatAsTheyRiseFromColumnToColumn) {
  const double row_height = 0.1;
  for (int k = -1; k <= d.grid.nz; ++k) {
    for (int i = -1; i <= d.grid.nx; ++i) {
      const double in_x = (eta_over(i + 1, k) - eta_over(i - 1, k)) / 2 / row_height,
                   in_z = (eta_over(i, k + 1) - eta_over(i, k - 1)) / 2 / row_height;
      EXPECT_NEAR(heights.flatness(i, k, row_height), 1 / (1 + in_x * in_x + in_z * in_z), 1e-12);
    }
  }
  const grid::VectorField none(d.grid, 3);
  heights.find(none.y, kAtRest);
  EXPECT_EQ(heights.flatness(0, 0, row_height), 1);
}

TEST(Heights, ReachTheWallWhereThereIsNoSurface) {
  Domain d(MPI_COMM_WORLD, {6, 8, 6}, {}, support::faces(8));
  grid::VectorField displacement(d.grid, 3);
  Heights heights(d.grid, 1);
  heights.find(displacement.y, -1);
  EXPECT_EQ(heights.lowest(), d.grid.y_face[0]);
  heights.find(displacement.y, d.grid.y_face[0]);  // at rest on the wall itself
  EXPECT_EQ(heights.lowest(), d.grid.y_face[0]);
}

TEST(Fraction, AddsUpToTheDepthOfTheSolid) {
  for (const double slope : {0.0, 0.1, 1.0}) {
    Domain d(MPI_COMM_WORLD, {12, 20, 9}, {}, support::faces(20, 2, 1.0));
    const auto eta = [=](double x, double z) {
      return 1.1 + slope * (0.3 * std::sin(kTau * x / 3) + 0.1 * std::cos(kTau * z / 1.5));
    };
    const auto displacement = raised(d, eta);
    Heights heights(d.grid, 2);
    heights.find(displacement.y, kAtRest);
    grid::Field phi(d.grid, 1);
    const int all_solid_from = CellFractions(d.grid).fill(heights, 0, phi);
    const auto least = [&](int j) {
      return -grid::max_cells({-1, d.grid.nx + 1, j, j + 1, -1, d.grid.nz + 1}, -1.0,
                              [&](int i, int row, int k) { return -phi(i, row, k); });
    };
    EXPECT_LT(least(all_solid_from - 1), 1);
    for (int j = all_solid_from; j < d.grid.ny; ++j) EXPECT_EQ(least(j), 1);
    double volume = 0, columns = 0;
    for (int k = 0; k < d.grid.nz; ++k) {
      for (int i = 0; i < d.grid.nx; ++i) {
        columns += d.grid.height - heights(i, k);
        for (int j = 0; j < d.grid.ny; ++j) {
          const double f = phi(i, j, k);
          ASSERT_TRUE(f >= 0 && f <= 1);
          volume += f * d.grid.dy[j];
          if (d.grid.y_face[j] > heights(i, k) + 0.3) {
            ASSERT_EQ(f, 1);
          }
          if (d.grid.y_face[j + 1] < heights(i, k) - 0.3) {
            ASSERT_EQ(f, 0);
          }
        }
      }
    }
    volume = parallel::sum(d.decomposition.all(), volume);
    columns = parallel::sum(d.decomposition.all(), columns);
    EXPECT_NEAR(volume, columns, 1e-12 * columns);  // smoothing to strips moves volume, but makes none
  }
}

TEST(Extrapolation, GoesOnInAStraightLineAndLeavesTheSolidAlone) {
  Domain d(MPI_COMM_WORLD, {9, 16, 8}, {}, support::faces(16, 2, 1.0));
  const auto& g = d.grid;
  const auto eta = [](double x, double) { return kAtRest + 0.25 * std::sin(kTau * x / 3); };
  auto displacement = raised(d, eta);
  const auto line = [](double x, double y, double z) { return std::cos(kTau * x / 3) * (2 - y) + 0.1 * z; };
  support::set_by_position(displacement.x, g, support::kFaceX, line);
  support::set_by_position(displacement.z, g, support::kFaceZ, line);
  Heights heights(g, 1);
  heights.find(displacement.y, kAtRest);
  const auto spoil = [&](grid::Field& f, const grid::RowArray& y, double dx) {
    for (int k = 0; k < g.nz; ++k) {
      for (int j = 0; j < g.ny; ++j) {
        for (int i = 0; i < g.nx; ++i) {
          // Far below any surface that the point might belong to.
          if (y[j] < eta((g.x_begin + i + dx) * g.dx, 0) - 0.06) f(i, j, k) = 1e3;
        }
      }
    }
  };
  grid::VectorField whole(g, 3);
  support::copy(displacement, whole);
  spoil(displacement.x, g.y_center, 0);
  spoil(displacement.y, g.y_face, 0.5);
  spoil(displacement.z, g.y_center, 0.5);
  Extrapolation(g).extend(heights, 0, displacement);
  const auto expect_same = [&](const grid::Field& a, const grid::Field& b, int top) {
    for (int k = 0; k < g.nz; ++k) {
      for (int j = 0; j < top; ++j) {
        for (int i = 0; i < g.nx; ++i) EXPECT_NEAR(a(i, j, k), b(i, j, k), 1e-12) << i << ' ' << j;
      }
    }
  };
  expect_same(displacement.x, whole.x, g.ny);
  expect_same(displacement.y, whole.y, g.ny + 1);
  expect_same(displacement.z, whole.z, g.ny);
}

}  // namespace
}  // namespace softwall::solid::reference_map
