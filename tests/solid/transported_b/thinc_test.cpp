#include "solver/solid/transported_b/thinc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/noise.hpp"

// The step in one cell: it holds what the cell holds, and its faces follow from its normal.
namespace softwall::solid {
namespace {

using Vector = std::array<double, 3>;

constexpr std::array<double, 9> kFractions{1e-8, 1e-5, 0.01, 0.2, 0.5, 0.8, 0.99, 1 - 1e-5, 1 - 1e-8};

Vector random_normal(int seed) {
  return {support::noise(seed, 0, 0, 0), support::noise(seed, 1, 0, 0), support::noise(seed, 2, 0, 0)};
}

/// Mean over the cell of the step along y that has these values on the lower and upper face in y: ln cosh is
/// the integral of tanh.
double mean_of_step(double low, double high) {
  const double beta = Thinc::kSharpness;
  const double at_low = std::atanh(2 * low - 1), at_high = std::atanh(2 * high - 1);
  return 0.5 + (std::log(std::cosh(at_high)) - std::log(std::cosh(at_low))) / (2 * beta);
}

TEST(Thinc, StepAlongAnAxisIsExact) {
  for (const double fraction : {0.01, 0.2, 0.5, 0.8, 0.99}) {
    const Thinc step(fraction, {0, 0.3, 0});
    const double low = step.on_face(1, false), high = step.on_face(1, true);
    EXPECT_NEAR(std::atanh(2 * high - 1) - std::atanh(2 * low - 1), Thinc::kSharpness, 1e-9);
    EXPECT_NEAR(mean_of_step(low, high), fraction, 1e-12);
  }
}

TEST(Thinc, FacesBesideAStepAlongAnAxisHoldWhatTheCellHolds) {
  for (const double fraction : kFractions) {
    const Thinc step(fraction, {0, -2, 0});
    for (const int axis : {0, 2}) {
      for (const bool high : {false, true})
        EXPECT_NEAR(step.on_face(axis, high), fraction, 1e-7 * std::min(fraction, 1 - fraction));
    }
  }
}

TEST(Thinc, FractionLiesBetweenOppositeFacesAndSolidIsWhereTheGradientPoints) {
  for (int seed = 0; seed < 200; ++seed) {
    const Vector n = random_normal(seed);
    for (const double fraction : kFractions) {
      const Thinc step(fraction, n);
      for (int axis = 0; axis < 3; ++axis) {
        const double low = step.on_face(axis, n[axis] < 0), high = step.on_face(axis, n[axis] > 0);
        EXPECT_GE(low, 0);
        EXPECT_LE(high, 1);
        EXPECT_LT(low, high);
        // Only along the main axis is the quadrature the cell's own.
        if (std::abs(n[axis]) < std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])})) continue;
        EXPECT_LT(low, fraction);
        EXPECT_GT(high, fraction);
      }
    }
  }
}

TEST(Thinc, HalfACellOfSolidIsSymmetricAboutItsCenter) {
  for (int seed = 0; seed < 50; ++seed) {
    const Thinc step(0.5, random_normal(seed));
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR((step.on_face(axis, false) + step.on_face(axis, true)) / 2, 0.5, 1e-12);
  }
}

TEST(Thinc, MirroredStepsHaveMirroredFaces) {
  for (int seed = 0; seed < 50; ++seed) {
    const Vector n = random_normal(seed);
    for (const double fraction : kFractions) {
      const Thinc step(fraction, n);
      for (int mirrored = 0; mirrored < 3; ++mirrored) {
        Vector m = n;
        m[mirrored] = -m[mirrored];
        const Thinc image(fraction, m);
        for (int axis = 0; axis < 3; ++axis)
          EXPECT_NEAR(image.on_face(axis, axis != mirrored), step.on_face(axis, true), 1e-12);
      }
    }
  }
}

TEST(Thinc, FluidIsTheComplementOfSolid) {
  for (int seed = 0; seed < 50; ++seed) {
    const Vector n = random_normal(seed);
    const Thinc solid(0.75, n), fluid(0.25, {-n[0], -n[1], -n[2]});
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(solid.on_face(axis, true), 1 - fluid.on_face(axis, true), 1e-14);
  }
}

}  // namespace
}  // namespace softwall::solid
