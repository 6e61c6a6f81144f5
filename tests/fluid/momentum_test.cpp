#include "solver/fluid/momentum.hpp"

#include <gtest/gtest.h>

#include "tests/support/linear_flow.hpp"
#include "tests/support/momentum_at_a_point.hpp"

// Each stencil is exact on the polynomials that its order promises.
namespace softwall::fluid {
namespace {

using support::Domain;
using support::kFaceX;
using support::kFaceY;
using support::kFaceZ;
using support::set_everywhere;

constexpr int kI = 2, kJ = 3, kK = 1;  // a cell away from every boundary

class Momentum : public testing::Test {
 protected:
  Domain d{MPI_COMM_WORLD, {6, 7, 5}, {3, 1.5}, support::faces(7)};

  /// R of the three components in the middle, for u, v, w given by formulas.
  template <class U, class V, class W>
  std::array<double, 3> rate(double nu, const U& u, const V& v, const W& w) {
    grid::VectorField velocity(d.grid, 1);
    set_everywhere(velocity.x, d.grid, kFaceX, u);
    set_everywhere(velocity.y, d.grid, kFaceY, v);
    set_everywhere(velocity.z, d.grid, kFaceZ, w);
    const auto m = momentum_input(velocity, d.grid, nu);
    return {momentum_x(m, kI, kJ, kK), momentum_y(m, kI, kJ, kK), momentum_z(m, kI, kJ, kK)};
  }
};

double zero(double, double, double) { return 0; }

TEST_F(Momentum, ConvectionIsExactForLinearFlow) {
  const auto& L = support::kGeneralFlow;
  const auto velocity = L.on(d.grid);
  const auto m = momentum_input(velocity, d.grid, 0);
  const auto& g = d.grid;
  const double xf = kI * g.dx, xc = xf + g.dx / 2, yf = g.y_face[kJ], yc = g.y_center[kJ], zf = kK * g.dz,
               zc = zf + g.dz / 2;
  const auto convection = [&](int a, double x, double y, double z) {  // (u . grad) u_a
    double sum = 0;
    for (int b = 0; b < 3; ++b) sum += L.gradient[a][b] * L.at(b, x, y, z);
    return sum;
  };
  EXPECT_NEAR(momentum_x(m, kI, kJ, kK), -convection(0, xf, yc, zc), 1e-12);
  EXPECT_NEAR(momentum_y(m, kI, kJ, kK), -convection(1, xc, yf, zc), 1e-12);
  EXPECT_NEAR(momentum_z(m, kI, kJ, kK), -convection(2, xc, yc, zf), 1e-12);
}

TEST_F(Momentum, ViscosityIsExactForQuadraticShear) {
  // Each direction of each component in turn; convection of a lone u_a(x_b), b != a, vanishes.
  const double nu = 0.3, exact = 2 * nu * 5;
  const auto y2 = [](double, double y, double) { return 5 * y * y; };
  const auto z2 = [](double, double, double z) { return 5 * z * z; };
  const auto x2 = [](double x, double, double) { return 5 * x * x; };
  EXPECT_NEAR(rate(nu, y2, zero, zero)[0], exact, 1e-11);
  EXPECT_NEAR(rate(nu, z2, zero, zero)[0], exact, 1e-11);
  EXPECT_NEAR(rate(nu, zero, x2, zero)[1], exact, 1e-11);
  EXPECT_NEAR(rate(nu, zero, z2, zero)[1], exact, 1e-11);
  EXPECT_NEAR(rate(nu, zero, zero, x2)[2], exact, 1e-11);
  EXPECT_NEAR(rate(nu, zero, zero, y2)[2], exact, 1e-11);
}

TEST_F(Momentum, ViscousStressHoldsTheTransposedGradientToo) {
  // u_a = x_b^2 makes no other component's rate; u_x = x y and v = -y^2 / 2 (solenoidal) is felt by both.
  const double nu = 0.3;
  const auto at_rest = rate(
      0, [](double x, double y, double) { return x * y; },
      [](double, double y, double) { return -y * y / 2; }, zero);
  const auto moved = rate(
      nu, [](double x, double y, double) { return x * y; },
      [](double, double y, double) { return -y * y / 2; }, zero);
  EXPECT_NEAR(moved[0] - at_rest[0], 0, 1e-12);    // laplacian of x y
  EXPECT_NEAR(moved[1] - at_rest[1], -nu, 1e-12);  // laplacian of -y^2 / 2
  EXPECT_NEAR(moved[2] - at_rest[2], 0, 1e-12);
}

TEST_F(Momentum, ConvectionOfEveryPairHasItsOwnSign) {
  // u_a = x_b carried by a constant u_b = c: R_a = -c.
  const double c = 2.5;
  const auto constant = [=](double, double, double) { return c; };
  const auto x = [](double px, double, double) { return px; };
  const auto y = [](double, double py, double) { return py; };
  const auto z = [](double, double, double pz) { return pz; };
  EXPECT_NEAR(rate(0, y, constant, zero)[0], -c, 1e-12);
  EXPECT_NEAR(rate(0, z, zero, constant)[0], -c, 1e-12);
  EXPECT_NEAR(rate(0, constant, x, zero)[1], -c, 1e-12);
  EXPECT_NEAR(rate(0, zero, z, constant)[1], -c, 1e-12);
  EXPECT_NEAR(rate(0, constant, zero, x)[2], -c, 1e-12);
  EXPECT_NEAR(rate(0, zero, constant, y)[2], -c, 1e-12);
}

}  // namespace
}  // namespace softwall::fluid
