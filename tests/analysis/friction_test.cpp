#include "analysis/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/student_t.hpp"

namespace softwall::analysis {
namespace {

TEST(Friction, LaminarPoiseuilleHasEqualWalls) {
  // U = 3/2 y (2 - y): dU/dy = 3 at the wall, P = 3/Re.
  const Friction f = friction({2800.0, 3.0 / 2800.0, 3.0 / 2800.0, 2.0});
  EXPECT_DOUBLE_EQ(f.re_tau_w, std::sqrt(3.0 * 2800.0));
  EXPECT_DOUBLE_EQ(f.re_tau, f.re_tau_w);
}

TEST(Friction, WallsShareTheDrivingForce) {
  for (const double bottom : {0.002, 0.004, 0.0063}) {
    const Friction f = friction({2800.0, 0.008, bottom, 2.0});
    EXPECT_NEAR(f.u_tau * f.u_tau + f.u_tau_w * f.u_tau_w, 0.016, 1e-15);
    EXPECT_DOUBLE_EQ(f.re_tau, 2800.0 * f.u_tau);
  }
}

TEST(Friction, PaperRowFourFollowsFromItsGradient) {
  // Table 1, softest wall: Re_tau_w 202.3 and Re_tau 307.0 mean P = 0.008621.
  const double bottom = std::pow(202.3 / 2800.0, 2);
  EXPECT_NEAR(friction({2800.0, 0.0086211, bottom, 2.0}).re_tau, 307.0, 0.05);
}

TEST(Friction, ImpossibleBalanceIsNotANumber) {
  EXPECT_TRUE(std::isnan(friction({2800.0, 0.001, 0.004, 2.0}).re_tau));
}

TEST(StudentT, AgreesWithTables) {
  EXPECT_NEAR(student_t_975(3), 3.18245, 0.02);
  EXPECT_NEAR(student_t_975(7), 2.36462, 5e-4);
  EXPECT_NEAR(student_t_975(15), 2.13145, 1e-4);
  EXPECT_NEAR(student_t_975(60), 2.00030, 1e-5);
}

}  // namespace
}  // namespace softwall::analysis
