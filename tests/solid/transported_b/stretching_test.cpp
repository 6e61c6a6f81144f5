#include "solver/solid/transported_b/stretching.hpp"

#include <gtest/gtest.h>

#include "tests/support/stretching_views.hpp"

// In a uniform velocity gradient L a uniform B changes at the rate L B + B L^T, on any grid.
namespace softwall::solid {
namespace {

using support::Domain;
using support::LinearFlow;

constexpr double kIdentity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr double kGeneral[3][3] = {{2.0, 0.3, -0.4}, {0.3, 1.5, 0.6}, {-0.4, 0.6, 0.9}};

class StretchingIn : public testing::TestWithParam<double> {
 protected:
  Domain d{MPI_COMM_WORLD, {6, 8, 5}, {}, support::faces(8, 2, GetParam())};

  void expect_rates(const LinearFlow& flow, const double (&B)[3][3]) {
    const auto& L = flow.gradient;
    const auto exact = [&](int a, int b) {
      double sum = 0;
      for (int c = 0; c < 3; ++c) sum += L[a][c] * B[c][b] + B[a][c] * L[b][c];
      return sum;
    };
    const auto material = support::uniform_material(d.grid, B);
    const auto velocity = flow.on(d.grid);
    const auto s = support::stretching(material, velocity, d.grid);
    for (int j = 1; j < d.grid.ny - 1; ++j) {
      EXPECT_NEAR(s.rate_xx(2, j, 2), exact(0, 0), 1e-12);
      EXPECT_NEAR(s.rate_yy(2, j, 2), exact(1, 1), 1e-12);
      EXPECT_NEAR(s.rate_zz(2, j, 2), exact(2, 2), 1e-12);
      EXPECT_NEAR(s.rate_xy(2, j, 2), exact(0, 1), 1e-12);
      EXPECT_NEAR(s.rate_xz(2, j, 2), exact(0, 2), 1e-12);
      EXPECT_NEAR(s.rate_yz(2, j, 2), exact(1, 2), 1e-12);
    }
  }
};

TEST_P(StretchingIn, GeneralFlowActsOnAGeneralTensor) { expect_rates(support::kGeneralFlow, kGeneral); }

TEST_P(StretchingIn, EachShearOfItsOwn) {
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      if (a == b) continue;
      LinearFlow flow{};
      flow.gradient[a][b] = 1.7;
      expect_rates(flow, kIdentity);
      expect_rates(flow, kGeneral);
    }
  }
}

TEST_P(StretchingIn, PureStrain) {
  expect_rates({{{1, 0, 0}, {0, -1, 0}, {0, 0, 0}}}, kGeneral);
  expect_rates({{{0, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, kGeneral);
  expect_rates({{{-2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, kGeneral);
}

TEST_P(StretchingIn, RigidRotationLeavesTheUndeformedSolidAlone) {
  for (const LinearFlow& rotation :
       {LinearFlow{{{0, -1, 0}, {1, 0, 0}, {0, 0, 0}}}, LinearFlow{{{0, 0, -1}, {0, 0, 0}, {1, 0, 0}}},
        LinearFlow{{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}}}}) {
    expect_rates(rotation, kIdentity);  // exact rate is zero
    expect_rates(rotation, kGeneral);
  }
}

TEST_P(StretchingIn, KeepsTheDeterminantOfAVolumePreservingFlow) {
  // d det B / dt = det B tr(B^-1 dB/dt) = 2 det B div u = 0, checked with the rates themselves.
  const auto material = support::uniform_material(d.grid, kGeneral);
  const auto velocity = support::kGeneralFlow.on(d.grid);
  const auto s = support::stretching(material, velocity, d.grid);
  const auto determinant = [&](double t) {
    const double xx = kGeneral[0][0] + t * s.rate_xx(2, 3, 2), yy = kGeneral[1][1] + t * s.rate_yy(2, 3, 2),
                 zz = kGeneral[2][2] + t * s.rate_zz(2, 3, 2), xy = kGeneral[0][1] + t * s.rate_xy(2, 3, 2),
                 xz = kGeneral[0][2] + t * s.rate_xz(2, 3, 2), yz = kGeneral[1][2] + t * s.rate_yz(2, 3, 2);
    return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  };
  EXPECT_NEAR((determinant(1e-5) - determinant(-1e-5)) / 2e-5, 0, 1e-8);
}

TEST_P(StretchingIn, WallsSeeTheShearOfTheVelocityAlongThem) {
  const LinearFlow flow{{{0, 1.5, 0}, {0, 0, 0}, {0, -0.8, 0}}};
  const auto material = support::uniform_material(d.grid, kIdentity);
  const auto velocity = flow.on(d.grid);
  const auto s = support::stretching(material, velocity, d.grid);
  for (const int wall : {0, d.grid.ny}) {
    EXPECT_NEAR(s.rate_xy_wall(2, wall, 2), 1.5, 1e-13);
    EXPECT_NEAR(s.rate_yz_wall(2, wall, 2), -0.8, 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, StretchingIn, testing::Values(0.0, 1.5));

}  // namespace
}  // namespace softwall::solid
