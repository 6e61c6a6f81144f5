#include <gtest/gtest.h>

#include <numbers>

#include "solver/case/step_limits.hpp"
#include "solver/time/advance.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"

// A standing shear wave in a solid that fills the box, exact at any amplitude:
//   u = v(t) sin(k y), displacement xi(t) sin(k y), xi'' + nu k^2 xi' + G k^2 xi = 0,
//   xi = V exp(-s t) sin(w t) / w,  s = nu k^2 / 2,  w^2 = G k^2 - s^2;  B_xy = k xi cos(k y),  B_xx = 1 +
//   B_xy^2.
namespace softwall::time {
namespace {

using support::kFaceX;

constexpr double kPi = std::numbers::pi, kG = 1, kReynolds = 50, kV = 0.5;

struct Wave {
  double k2;  ///< the (discrete) second derivative's eigenvalue
  double G = kG, nu = 1 / kReynolds;
  double s() const { return nu * k2 / 2; }
  double w() const { return std::sqrt(G * k2 - s() * s()); }
  double displacement(double t) const { return kV * std::exp(-s() * t) * std::sin(w() * t) / w(); }
  double velocity(double t) const {
    return kV * std::exp(-s() * t) * (std::cos(w() * t) - s() / w() * std::sin(w() * t));
  }
};

struct Errors {
  double velocity, shear, stretch;
};

/// The wave sin(pi y) after T = 1.3, in u or, turned by 90 degrees, in w; compared with `wave`.
Errors run_wave(SolidFormulation formulation, int ny, double stretching, double viscosity_ratio, int steps,
                bool turned, const Wave& wave) {
  Physics p = support::solid_box({1, ny, 0, 1});
  p.reynolds = kReynolds;
  p.grid.stretching = stretching;
  p.solid->viscosity_ratio = viscosity_ratio;
  p.solid->formulation = formulation;
  time::Setup setup(p, MPI_COMM_WORLD);
  setup.bulk_velocity.reset();
  State s = state_at_rest(setup.grid, SolidFormulation::kTransportedB);
  s.material = support::solid_everywhere(setup.grid, formulation);
  auto& moving = turned ? s.velocity.z : s.velocity.x;
  const auto& g = setup.grid;
  support::set_by_position(moving, g, kFaceX,
                           [](double, double y, double) { return kV * std::sin(kPi * y); });
  start(s, setup);
  const double T = 1.3;
  for (int step = 0; step < steps; ++step) advance(s, setup, T / steps);
  const double v = wave.velocity(T), xi = kPi * wave.displacement(T);
  const auto& B = s.material.B;
  const auto error = [&](const grid::Field& f, const support::Place& place, const auto& exact) {
    return support::largest_error(f, g, place, setup.decomposition,
                                  [&](double, double y, double) { return exact(y); });
  };
  const auto& of_time = turned ? s.velocity.z : s.velocity.x;
  return {error(of_time, kFaceX, [&](double y) { return v * std::sin(kPi * y); }),
          error(turned ? B.yz : B.xy, support::kEdgeXy, [&](double y) { return xi * std::cos(kPi * y); }),
          error(turned ? B.zz : B.xx, support::kCenter,
                [&](double y) { return 1 + std::pow(xi * std::cos(kPi * y), 2); })};
}

void expect_second_order_in_space(SolidFormulation formulation, double stretching, double ratio,
                                  bool turned) {
  SCOPED_TRACE(testing::Message() << "stretching " << stretching << ", viscosity ratio " << ratio
                                  << (turned ? ", in w" : ", in u"));
  const Wave wave{kPi * kPi, kG, ratio / kReynolds};
  const auto errors = [&](int ny) {
    return run_wave(formulation, ny, stretching, ratio, 10 * ny, turned, wave);
  };
  const Errors coarse = errors(16), middle = errors(32), fine = errors(64);
  EXPECT_NEAR(support::observed_order(coarse.velocity, middle.velocity), 2, 0.3);
  EXPECT_NEAR(support::observed_order(middle.velocity, fine.velocity), 2, 0.15);
  EXPECT_NEAR(support::observed_order(middle.shear, fine.shear), 2, 0.15);
  EXPECT_NEAR(support::observed_order(middle.stretch, fine.stretch), 2, 0.15);
  EXPECT_LT(fine.velocity, 5e-3 * kV);
  support::report("shear wave, u", {coarse.velocity / kV, middle.velocity / kV, fine.velocity / kV});
  support::report("shear wave, B_xy", {coarse.shear, middle.shear, fine.shear});
  support::report("shear wave, B_xx", {coarse.stretch, middle.stretch, fine.stretch});
}

class ShearWave : public testing::TestWithParam<SolidFormulation> {};

TEST_P(ShearWave, IsSecondOrderInSpace) { expect_second_order_in_space(GetParam(), 0, 1, false); }
TEST_P(ShearWave, IsSecondOrderInSpaceInW) { expect_second_order_in_space(GetParam(), 0, 1, true); }
TEST_P(ShearWave, IsSecondOrderInSpaceOnAStretchedGrid) {
  expect_second_order_in_space(GetParam(), 1.2, 1, false);
}
TEST_P(ShearWave, FeelsTheViscosityOfTheSolid) { expect_second_order_in_space(GetParam(), 0, 10, false); }

TEST_P(ShearWave, IsSecondOrderInTimeAtLeast) {
  // Against the wave of the discrete operator, whose eigenvalue is known, so that only time steps err.
  const int ny = 12;
  const double dy = 2.0 / ny;
  const Wave discrete{std::pow(2 * std::sin(kPi * dy / 2) / dy, 2), kG, 1 / kReynolds};
  const auto error = [&](int steps) {
    return run_wave(GetParam(), ny, 0, 1, steps, false, discrete).velocity;
  };
  const double coarse = error(26), middle = error(52), fine = error(104);
  EXPECT_GT(support::observed_order(coarse, middle), 1.9) << coarse << ' ' << middle;
  EXPECT_GT(support::observed_order(middle, fine), 1.9) << middle << ' ' << fine;
  support::report("shear wave, time step", {coarse, middle, fine});
}

/// An antiplane wave w = v(t) sin(kx x) sin(ky y), exact at any amplitude, too; after T = 1.3 against that of
/// the discrete operator, whose eigenvalue is known. kx = 2 pi m / 6, ky = pi n / 2.
double error_of_antiplane_wave(SolidFormulation formulation, int m, int n, int steps) {
  Physics p = support::solid_box({12, 24, 0, 1});
  p.length_x = 6;
  p.length_z = 3;
  p.reynolds = kReynolds;
  p.solid->formulation = formulation;
  time::Setup setup(p, MPI_COMM_WORLD);
  setup.bulk_velocity.reset();
  State s = state_at_rest(setup.grid, SolidFormulation::kTransportedB);
  s.material = support::solid_everywhere(setup.grid, formulation);
  const auto& g = setup.grid;
  const double kx = kPi * m / 3, ky = kPi * n / 2;
  const auto shape = [=](double x, double y, double) { return std::sin(kx * x) * std::sin(ky * y); };
  support::set_by_position(s.velocity.z, g, support::kFaceZ,
                           [=](double x, double y, double z) { return kV * shape(x, y, z); });
  start(s, setup);
  const double T = 1.3, dy = g.dy[0];
  for (int step = 0; step < steps; ++step) advance(s, setup, T / steps);
  const Wave wave{std::pow(2 * std::sin(kx * g.dx / 2) / g.dx, 2) +
                  std::pow(2 * std::sin(ky * dy / 2) / dy, 2)};
  return support::largest_error(
      s.velocity.z, g, support::kFaceZ, setup.decomposition,
      [=](double x, double y, double z) { return wave.velocity(T) * shape(x, y, z); });
}

/// Through y, obliquely, and nearly along x.
TEST_P(ShearWave, IsSecondOrderInTimeAsFarAsFourTimesTheExplicitLimit) {
  const step_limits::InverseSpacings<double> inv{12 / 6.0, 24 / 2.0, 1};
  const double limit =
      step_limits::elastic(Stiffness::kExplicit, {kG},
                           step_limits::stiffness(step_limits::Deformation<double>{1, 1, 1, 0, 0, 0}, inv));
  const int most = static_cast<int>(1.3 / (4 * limit));  // steps a little longer than four times the limit
  for (const auto& [m, n] : {std::pair{2, 2}, std::pair{3, 1}}) {
    const auto error = [&](int steps) { return error_of_antiplane_wave(GetParam(), m, n, steps); };
    const std::vector<double> errors{error(most), error(2 * most), error(4 * most)};
    SCOPED_TRACE(testing::Message() << "m = " << m << ", n = " << n);
    support::expect_order("antiplane wave, time steps of 4, 2, 1 times the explicit limit", errors, 1.9);
  }
  const double dy = 2.0 / 24;
  const Wave discrete{std::pow(2 * std::sin(kPi * dy / 2) / dy, 2), kG, 1 / kReynolds};
  const auto through = [&](int steps) {
    return run_wave(GetParam(), 24, 0, 1, steps, false, discrete).velocity;
  };
  support::expect_order("shear wave through y, the same",
                        std::vector<double>{through(most), through(2 * most), through(4 * most)}, 1.9);
}

INSTANTIATE_TEST_SUITE_P(, ShearWave, testing::ValuesIn(support::kBothFormulations),
                         [](const auto& test) { return support::name_of(test.param); });

}  // namespace
}  // namespace softwall::time
