#include <gtest/gtest.h>

#include <numbers>

#include "solver/solid/cofactors.hpp"
#include "solver/statistics/profiles.hpp"
#include "solver/time/advance.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/solids.hpp"

// A Mooney-Rivlin solid with constants c1 and c2. In simple shear by gamma
//   s_xy = (c1 + c2) gamma,   s_xx - s_yy = (c1 + c2) gamma^2,   s_yy - s_zz = -c2 gamma^2:
// in the last a neo-Hookean solid has nothing.
namespace softwall::time {
namespace {

constexpr double kPi = std::numbers::pi, kG = 1, kShare = 0.4, kC2 = kShare * kG;

class MooneyRivlin : public testing::TestWithParam<SolidFormulation> {
 protected:
  static Physics box_of_solid(support::Cells n) {
    Physics p = support::formulated(support::solid_box(n), GetParam());
    p.solid->G = kG;
    p.solid->mooney_share = kShare;
    return p;
  }
};

TEST_P(MooneyRivlin, StressInFiniteShearIsThatOfBothConstants) {
  const double gamma = 1.5;
  const Physics p = box_of_solid({4, 12, 0, 4});
  time::Setup setup(p, MPI_COMM_WORLD);
  const auto& g = setup.grid;
  State s = state_at_rest(setup.grid, SolidFormulation::kTransportedB);
  s.material = support::solid_everywhere(g, GetParam());
  support::shear_material(
      s.material, g, 0, [=](double y) { return gamma * y; }, [=](double) { return gamma; });
  start(s, setup);
  const auto means = statistics::plane_means(s, setup);
  using namespace statistics;
  for (int j = 2; j < g.ny - 2; ++j) {  // the walls hold a map fast, which knows no such shear there
    EXPECT_NEAR(means(kElasticStress, j), kG * gamma, 1e-12);
    EXPECT_NEAR(means(kElasticXx, j) - means(kElasticYy, j), kG * gamma * gamma, 1e-12);
    EXPECT_NEAR(means(kElasticYy, j) - means(kElasticZz, j), -kC2 * gamma * gamma, 1e-12);
  }
}

struct WaveErrors {
  double velocity, pressure;
};

/// The standing wave of shear_wave_test.cpp, whose speed is sqrt((c1 + c2) / rho), after T = 1.3. Across its
/// planes the pressure balances s_yy = -c2 (gamma^2 - <gamma^2>) + const, gamma = k xi cos(k y).
WaveErrors run_wave(const Physics& p, int steps) {
  constexpr double kV = 0.5, T = 1.3, nu = 1.0 / 50;
  time::Setup setup(p, MPI_COMM_WORLD);
  setup.bulk_velocity.reset();
  const auto& g = setup.grid;
  State s = state_at_rest(setup.grid, SolidFormulation::kTransportedB);
  s.material = support::solid_everywhere(g, p.solid->formulation);
  support::set_by_position(s.velocity.x, g, support::kFaceX,
                           [](double, double y, double) { return kV * std::sin(kPi * y); });
  start(s, setup);
  for (int step = 0; step < steps; ++step) advance(s, setup, T / steps);
  const double decay = nu * kPi * kPi / 2, w = std::sqrt(kG * kPi * kPi - decay * decay),
               amplitude = kV * std::exp(-decay * T),
               velocity = amplitude * (std::cos(w * T) - decay / w * std::sin(w * T)),
               gamma = kPi * amplitude * std::sin(w * T) / w;
  const auto pressure = [&](double y) { return -kC2 * std::pow(gamma * std::cos(kPi * y), 2); };
  double mean = 0;
  for (int j = 0; j < g.ny; ++j) mean += (s.pressure(0, j, 0) - pressure(g.y_center[j])) * g.dy[j] / 2;
  return {support::largest_error(s.velocity.x, g, support::kFaceX, setup.decomposition,
                                 [&](double, double y, double) { return velocity * std::sin(kPi * y); }) /
              kV,
          support::largest_error(s.pressure, g, support::kCenter, setup.decomposition,
                                 [&](double, double y, double) { return mean + pressure(y); }) /
              (kC2 * gamma * gamma)};
}

TEST_P(MooneyRivlin, ShearWaveHasTheSpeedAndThePressureOfBothConstants) {
  std::vector<double> velocity, pressure;
  for (const int ny : {16, 32, 64}) {
    Physics p = box_of_solid({1, ny, 0, 1});
    p.reynolds = 50;
    const WaveErrors errors = run_wave(p, 10 * ny);
    velocity.push_back(errors.velocity);
    pressure.push_back(errors.pressure);
  }
  support::expect_order("shear wave in a Mooney-Rivlin solid, u", velocity, 1.85);
  EXPECT_LT(velocity.back(), 5e-3);
  support::report("shear wave in a Mooney-Rivlin solid, pressure", pressure);
  EXPECT_LT(pressure.back(), 0.02);
}

INSTANTIATE_TEST_SUITE_P(, MooneyRivlin, testing::ValuesIn(support::kBothFormulations),
                         [](const auto& test) { return support::name_of(test.param); });

}  // namespace
}  // namespace softwall::time
