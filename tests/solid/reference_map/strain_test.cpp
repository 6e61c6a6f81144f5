#include "solver/solid/reference_map/strain.hpp"

#include <gtest/gtest.h>

#include "tests/support/fields.hpp"
#include "tests/support/momentum_views.hpp"

namespace softwall::solid::reference_map {
namespace {

using Matrix = double[3][3];

/// F = I + something general, volume kept by the last row.
void expect_b_of(const MapGradient& A, const Matrix& F) {
  double B[3][3] = {};
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      for (int c = 0; c < 3; ++c) B[a][b] += F[a][c] * F[b][c];
    }
  }
  const SymmetricTensor found = left_cauchy_green(A);
  EXPECT_NEAR(found.xx, B[0][0], 1e-13);
  EXPECT_NEAR(found.yy, B[1][1], 1e-13);
  EXPECT_NEAR(found.zz, B[2][2], 1e-13);
  EXPECT_NEAR(found.xy, B[0][1], 1e-13);
  EXPECT_NEAR(found.xz, B[0][2], 1e-13);
  EXPECT_NEAR(found.yz, B[1][2], 1e-13);
}

/// F with determinant 1 and its inverse, both exact: three shears one after another.
constexpr double a = 0.5, b = -0.25, c = 0.75;
constexpr Matrix kF = {{1 + a * b, a, a* c}, {b, 1, c}, {0, 0, 1}};
constexpr MapGradient kInverse{1, -a, 0, -b, 1 + a* b, -c, 0, 0, 1};

TEST(Strain, BOfAVolumePreservingMap) {
  EXPECT_NEAR(kInverse.determinant(), 1, 1e-15);
  expect_b_of(kInverse, kF);
}

TEST(Strain, AFalseChangeOfVolumeIsNotSeen) {
  for (const double s : {0.75, 0.9, 1.2, 1.5}) {
    const auto& A = kInverse;
    expect_b_of({s * A.xx, s * A.xy, s * A.xz, s * A.yx, s * A.yy, s * A.yz, s * A.zx, s * A.zy, s * A.zz},
                kF);
  }
}

TEST(Strain, VolumeFactorIsThePower) {
  for (double J = 0.3; J < 4; J *= 1.1) EXPECT_NEAR(volume_factor(J) * std::pow(J, 4.0 / 3), 1, 1e-13) << J;
  EXPECT_EQ(volume_factor(1), 1);
  for (const double J : {-3.0, 0.0, 0.05}) EXPECT_EQ(volume_factor(J), volume_factor(kLeastVolume));
  for (double J = 5; J < 1e6; J *= 3) {
    EXPECT_GT(volume_factor(J), 0);
    EXPECT_LT(volume_factor(J), 1);
  }
}

TEST(Strain, IsPositiveDefiniteHoweverTornTheMap) {
  for (int n = 0; n < 1000; ++n) {
    const auto r = [&](int m) { return 2 * support::noise(n, m, 0, 0); };
    const MapGradient A{r(0), r(1), r(2), r(3), r(4), r(5), r(6), r(7), r(8)};
    const SymmetricTensor B = left_cauchy_green(A);
    EXPECT_TRUE(std::isfinite(B.trace()));
    EXPECT_GT(min_eigenvalue(B), -1e-7 * B.trace());
  }
}

class GradientOf : public testing::TestWithParam<double> {};

TEST_P(GradientOf, ALinearDisplacementIsExactEverywhere) {
  support::Domain d(MPI_COMM_WORLD, {5, 6, 4}, {}, support::faces(6, 2, GetParam()));
  const auto& flow = support::kGeneralFlow;
  const auto displacement = flow.on(d.grid, 3);
  const Strain strain = strain_of(displacement, d.grid);
  const auto expect = [&](const MapGradient& A) {
    const double found[3][3] = {{A.xx, A.xy, A.xz}, {A.yx, A.yy, A.yz}, {A.zx, A.zy, A.zz}};
    for (int r = 0; r < 3; ++r) {
      for (int s = 0; s < 3; ++s) EXPECT_NEAR(found[r][s], (r == s ? 1 : 0) - flow.gradient[r][s], 1e-12);
    }
  };
  for (int j = 0; j < d.grid.ny; ++j) {
    expect(strain.center(1, j, 2));
    expect(strain.edge_xy(1, j, 2));
    expect(strain.edge_xz(1, j, 2));
    expect(strain.edge_yz(1, j, 2));
  }
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, GradientOf, testing::Values(0.0, 1.5));

}  // namespace
}  // namespace softwall::solid::reference_map
