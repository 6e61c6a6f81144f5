#include "solver/solid/symmetric_tensor.hpp"

#include <gtest/gtest.h>

#include "tests/support/noise.hpp"

namespace softwall::solid {
namespace {

/// Q diag(a, b, c) Q^T with Q a rotation about two axes.
SymmetricTensor rotated(double a, double b, double c, double first, double second) {
  const double cf = std::cos(first), sf = std::sin(first), cs = std::cos(second), ss = std::sin(second);
  const double q[3][3] = {{cf, -sf * cs, sf * ss}, {sf, cf * cs, -cf * ss}, {0, ss, cs}};
  const double d[3] = {a, b, c};
  const auto entry = [&](int i, int j) {
    double sum = 0;
    for (int m = 0; m < 3; ++m) sum += q[i][m] * d[m] * q[j][m];
    return sum;
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

TEST(SymmetricTensor, KnowsTheInvariantsOfARotatedDiagonal) {
  for (int n = 0; n < 200; ++n) {
    const double a = support::noise(n, 1, 0, 0), b = 3 * support::noise(n, 2, 0, 0),
                 c = 10 * support::noise(n, 3, 0, 0);
    const auto t = rotated(a, b, c, 3 * support::noise(n, 4, 0, 0), 3 * support::noise(n, 5, 0, 0));
    EXPECT_NEAR(t.trace(), a + b + c, 1e-13);
    EXPECT_NEAR(t.determinant(), a * b * c, 1e-12);
    EXPECT_NEAR(min_eigenvalue(t), std::min({a, b, c}), 1e-12);
    EXPECT_EQ(t.positive_definite(), std::min({a, b, c}) > 0);
  }
}

TEST(SymmetricTensor, FindsRepeatedEigenvalues) {
  EXPECT_DOUBLE_EQ(min_eigenvalue({}), 1);
  EXPECT_DOUBLE_EQ(min_eigenvalue({3, 3, 3, 0, 0, 0}), 3);
  for (const double angle : {0.0, 0.3, 1.2}) {
    EXPECT_NEAR(min_eigenvalue(rotated(2, 2, 5, angle, 0.7)), 2,
                1e-7);  // a double root costs half the digits
    EXPECT_NEAR(min_eigenvalue(rotated(2, 5, 5, angle, 0.7)), 2, 1e-7);
  }
}

TEST(SymmetricTensor, KnowsSimpleShear) {
  // B of simple shear by g: eigenvalues 1 and 1 + g^2/2 -+ g sqrt(1 + g^2/4), determinant 1 for any g.
  for (const double g : {0.1, 1.0, 3.0}) {
    const SymmetricTensor B{1 + g * g, 1, 1, g, 0, 0};
    EXPECT_NEAR(B.determinant(), 1, 1e-14);
    EXPECT_NEAR(min_eigenvalue(B), 1 + g * g / 2 - g * std::sqrt(1 + g * g / 4), 1e-12);
    EXPECT_TRUE(B.positive_definite());
  }
}

TEST(SymmetricTensor, ShiftMovesEveryEigenvalue) {
  const auto t = rotated(0.5, 2, 3, 0.4, 1.1);
  EXPECT_NEAR(min_eigenvalue(t.shifted(-0.7)), -0.2, 1e-12);
  EXPECT_FALSE(t.shifted(-0.7).positive_definite());
  EXPECT_TRUE(t.shifted(-0.3).positive_definite());
}

}  // namespace
}  // namespace softwall::solid
