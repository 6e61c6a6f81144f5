#include "solver/solid/reference_map/strain.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "solver/solid/reference_map/strain_sweep.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/linear_flow.hpp"
#include "tests/support/no_follower.hpp"
#include "tests/support/strain_at_edges.hpp"

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
  for (const double s : {0.8, 0.9, 1.2, 1.5}) {  // from det A = 0.51 on
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

TEST(Strain, ATornPointBearsNoStress) {
  const auto scaled = [](double s) {
    const auto& A = kInverse;
    return left_cauchy_green(
        {s * A.xx, s * A.xy, s * A.xz, s * A.yx, s * A.yy, s * A.yz, s * A.zx, s * A.zy, s * A.zz});
  };
  const double whole = scaled(1).xy;
  ASSERT_GT(std::abs(whole), 0.01);
  double before = whole;
  for (const double J : {0.4, 0.3, 0.2}) {  // the rest falls as det A does
    const double left = scaled(std::cbrt(J)).xy;
    EXPECT_LT(left / before, 1) << J;
    EXPECT_GT(left / before, 0) << J;
    before = left;
  }
  for (const double s : {0.45, 0.1, -1.0}) {
    const SymmetricTensor B = scaled(s);
    for (const double normal : {B.xx, B.yy, B.zz}) EXPECT_EQ(normal, 1) << s;
    for (const double shear : {B.xy, B.xz, B.yz}) EXPECT_EQ(shear, 0) << s;
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
    expect(edge_xy(strain, 1, j, 2));
    expect(edge_xz(strain, 1, j, 2));
    expect(edge_yz(strain, 1, j, 2));
  }
}

/// The sweep keeps means from row to row; it must find what the kernels find at each place alone.
TEST(StrainSweep, FindsWhatTheKernelsFindAtEachPlace) {
  for (const support::Domain::Size& n : {support::Domain::Size{9, 7, 4}, {16, 5, 3}}) {
    support::Domain d(MPI_COMM_WORLD, n, {}, support::faces(n.ny, 2, 1.4));
    const auto& g = d.grid;
    grid::VectorField displacement(g, 3);
    int seed = 0;
    for (grid::Field* f : {&displacement.x, &displacement.y, &displacement.z}) {
      ++seed;
      grid::for_each_cell({-3, g.nx + 3, -3, g.ny + 3, -3, g.nz + 3},
                          [&](int i, int j, int k) { (*f)(i, j, k) = 0.02 * support::noise(seed, i, j, k); });
    }
    const Strain strain = strain_of(displacement, g);
    for (const int first_row : {0, 2}) {
      grid::TensorField B(g, 1);
      grid::Field phi(g, 1), error(g, 1);
      grid::for_each_cell({-1, g.nx + 1, 0, g.ny, -1, g.nz + 1},
                          [&](int i, int j, int k) { phi(i, j, k) = i % 3 == 0 ? 0.5 : 1; });
      Damage damage({1}, g);
      support::NoFollower nobody;
      StrainSweep(g).run(
          strain, std::as_const(phi).view(), first_row,
          {B.xx.view(), B.yy.view(), B.zz.view(), B.xy.view(), B.xz.view(), B.yz.view(), error.view()},
          damage, nobody);
      double worst = 0, largest = 0;
      const auto compare = [&](double found, double expected) {
        worst = support::worse(worst, std::abs(found - expected));
        largest = support::worse(largest, std::abs(expected - 1));
      };
      for (int k = -1; k <= g.nz; ++k) {
        for (int j = first_row; j <= g.ny; ++j) {
          for (int i = -1; i <= g.nx; ++i) {
            const bool edge = i >= 0 && k >= 0, center = i < g.nx && k < g.nz;
            if (edge && k < g.nz) compare(B.xy(i, j, k), left_cauchy_green(edge_xy(strain, i, j, k)).xy);
            if (edge && i < g.nx) compare(B.yz(i, j, k), left_cauchy_green(edge_yz(strain, i, j, k)).yz);
            if (j == g.ny) continue;
            if (edge) compare(B.xz(i, j, k), left_cauchy_green(edge_xz(strain, i, j, k)).xz);
            if (!center) continue;
            const MapGradient A = strain.center(i, j, k);
            compare(error(i, j, k), volume_error(phi(i, j, k), A.determinant()));
            compare(B.xx(i, j, k), left_cauchy_green(A).xx);
            compare(B.yy(i, j, k), left_cauchy_green(A).yy);
            compare(B.zz(i, j, k), left_cauchy_green(A).zz);
          }
        }
      }
      EXPECT_GT(largest, 0.1);
      EXPECT_LT(worst, 1e-12 * largest);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, GradientOf, testing::Values(0.0, 1.5));

}  // namespace
}  // namespace softwall::solid::reference_map
