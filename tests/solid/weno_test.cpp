#include "solver/solid/weno.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "tests/support/order.hpp"
#include "tests/support/round_off.hpp"

namespace softwall::solid {
namespace {

using Value = std::function<double(double)>;
using Reconstruct = Real (*)(Real, Real, Real, Real, Real);

constexpr std::array<Reconstruct, 2> kBoth{&weno5<WenoWeights::kJiangShu>, &weno5<WenoWeights::kZ>};

/// Value on the face at x = face from the means of five cells of width h; primitive' is what is averaged.
double face_value(Reconstruct weno, const Value& primitive, double face, double h) {
  const auto mean = [&](int cell) {  // cell 0 ends at the face
    const double right = face + cell * h;
    return (primitive(right) - primitive(right - h)) / h;
  };
  return weno(mean(-2), mean(-1), mean(0), mean(1), mean(2));
}

TEST(Weno, IsExactForQuadratics) {
  // Each of the three small stencils is, so the weights cannot matter.
  for (const auto weno : kBoth) {
    for (const double h : {1.0, 0.1}) {
      const auto primitive = [](double x) { return 3 * x + 2 * x * x - x * x * x / 3 * 1.5; };
      const auto exact = [](double x) { return 3 + 4 * x - 1.5 * x * x; };
      for (const double face : {-1.0, 0.0, 0.7})
        EXPECT_NEAR(face_value(weno, primitive, face, h), exact(face), support::round_off(500));
    }
  }
}

TEST(Weno, KeepsConstantsToTheLastBits) {
  for (const auto weno : kBoth) {
    for (const double value : {0.0, 1.0, 1.0 / 3, 1e8, -1e-8}) {
      const Real c = Real(value);
      EXPECT_NEAR(weno(c, c, c, c, c), c, support::round_off(2) * std::abs(c));
    }
  }
}

TEST(Weno, IsFifthOrderOnSmoothData) {
  if (sizeof(Real) == sizeof(float)) GTEST_SKIP() << "its errors are below single precision's round-off";
  for (const auto weno : kBoth) {
    const auto error = [&](int n) {
      double total = 0;
      for (int cell = 0; cell < n; ++cell) {
        const double face = 1 + double(cell) / n;
        total += std::abs(face_value(
                              weno, [](double x) { return std::exp(x); }, face, 1.0 / n) -
                          std::exp(face));
      }
      return total / n;
    };
    EXPECT_NEAR(support::observed_order(error(20), error(40)), 5, 0.25);
    EXPECT_NEAR(support::observed_order(error(40), error(80)), 5, 0.15);
  }
}

TEST(Weno, StaysBetweenTheValuesAtAJump) {
  for (const auto weno : kBoth) {
    for (const auto& q :
         {std::array{0., 0., 0., 1., 1.}, {0., 0., 0., 0., 1.}, {1., 1., 0., 0., 0.}, {1., 0., 0., 0., 0.}}) {
      for (const double size : {1.0, 500.0}) {
        std::array<Real, 5> jump{};
        for (std::size_t n = 0; n < q.size(); ++n) jump[n] = Real(size * q[n]);
        const double value = weno(jump[0], jump[1], jump[2], jump[3], jump[4]) / size;
        EXPECT_GT(value, -0.01) << size;
        EXPECT_LT(value, 1.01) << size;
      }
    }
  }
}

TEST(Weno, IsBlindToTheSignOfTheData) {
  for (const auto weno : kBoth) EXPECT_EQ(weno(1, 2, 4, 3, 0), -weno(-1, -2, -4, -3, 0));
}

TEST(UpwindFlux, LooksUpstream) {
  // A ramp up to the face and a plateau beyond it, and the same seen from the other side.
  const std::array<Real, 6> q{1, 2, 3, 9, 9, 9}, mirrored{9, 9, 9, 3, 2, 1};
  constexpr auto kZ = WenoWeights::kZ;
  EXPECT_NEAR(upwind_flux<kZ>(&q[3], 1, 2.0), 2 * 3.5, 0.2);
  EXPECT_NEAR(upwind_flux<kZ>(&q[3], 1, -2.0), -2 * 9, support::round_off(200));
  EXPECT_EQ(upwind_flux<kZ>(&q[3], 1, 2.0), -upwind_flux<kZ>(&mirrored[3], 1, -2.0));
  EXPECT_EQ(upwind_flux<kZ>(&q[3], 1, 0.0), 0);
}

}  // namespace
}  // namespace softwall::solid
