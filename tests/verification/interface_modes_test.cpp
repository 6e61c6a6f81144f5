#include <gtest/gtest.h>

#include <numbers>

#include "solver/case/interface_mode.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/interface_wave.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/linear_algebra.hpp"
#include "tests/support/solids.hpp"

// Waves of small amplitude at the interface of a fluid at rest and a bonded layer: started as the mode of
// linear theory, they must turn and decay at its rate.
namespace softwall::time {
namespace {

using support::Complex;

/// Rates s of fluid 1 deep under a layer 0.5 thick, wavelength 1, rho = 1; mode 0 turns slowest. Roots of the
/// dispersion relation of case/interface_mode.hpp, found with an independent program.
struct Row {
  const char* name;
  double nu_f, nu_s, G;
  Complex s;
};
constexpr Row kViscous0{"nu 0.01, mode 0", 0.01, 0.01, 1, {-0.4397377964, 5.767953706}},
    kViscous1{"nu 0.01, mode 1", 0.01, 0.01, 1, {-1.464371764, 10.27203211}},
    kSoft0{"nu 0.01, G 0.25, mode 0", 0.01, 0.01, 0.25, {-0.3889917504, 2.831215715}},
    kThinner0{"nu 0.01 under 0.001, mode 0", 0.01, 0.001, 1, {-0.287302271, 5.779670686}},
    kThinner1{"nu 0.01 under 0.001, mode 1", 0.01, 0.001, 1, {-0.9678293228, 10.34876423}},
    kThicker0{"nu 0.01 under 0.04, mode 0", 0.01, 0.04, 1, {-0.946707025682, 5.69884838113}};

/// The code's fluid is 2 deep: lengths and times are twice the table's, velocities the same.
constexpr double kScale = 2;

Physics physics_of(const Row& row, const SolidSpec& solid, int nx) {
  Physics p = support::elastic_channel({nx, nx, nx / 2, 1});
  p.flow = FlowType::kInterfaceWave;
  p.length_x = kScale;
  p.length_z = 10 * kScale;  // so that dz limits nothing
  p.layer_height = 0.5 * kScale;
  p.reynolds = 1 / (row.nu_f * kScale);
  p.solid = support::made_of(solid, row.G, row.nu_s / row.nu_f);
  p.wave =
      WaveSpec{.decay = -row.s.real() / kScale, .frequency = row.s.imag() / kScale, .displacement = 1e-4};
  return p;
}

/// cos(k x) part of v on all faces.
std::vector<double> wave_in(const State& s, const Setup& setup) {
  const auto& g = setup.grid;
  std::vector<double> parts;
  for (int j = 1; j < g.ny; ++j) {
    double sum = 0;
    for (int i = 0; i < g.nx; ++i)
      sum += s.velocity.y(i, j, 0) * std::cos(2 * std::numbers::pi * (i + 0.5) / g.nx);
    parts.push_back(sum);
  }
  return parts;
}

Complex rate_on(const Row& row, const SolidSpec& solid, int nx) {
  Setup setup(physics_of(row, solid, nx), MPI_COMM_WORLD);
  State s = interface_wave_at_start(setup);
  const double interval = 2 * std::numbers::pi / setup.physics.wave->frequency / 16;
  const int steps = static_cast<int>(std::ceil(interval / choose_time_step(s, setup).dt));
  std::vector<std::vector<double>> records{wave_in(s, setup)};
  for (int n = 0; n < 32; ++n) {  // two periods
    for (int step = 0; step < steps; ++step) advance(s, setup, interval / steps);
    records.push_back(wave_in(s, setup));
  }
  return support::oscillation_rate(records, interval) * kScale;
}

class InterfaceModes : public testing::TestWithParam<support::NamedSolid> {
 protected:
  struct Errors {
    std::vector<double> rate, frequency, decay;  ///< relative, on 16, 32 and 64 cells per wave
  };
  static Errors measure(const Row& row) {
    Errors e;
    for (const int nx : {16, 32, 64}) {
      const Complex s = rate_on(row, GetParam().spec, nx);
      e.rate.push_back(std::abs(s - row.s) / std::abs(row.s));
      e.frequency.push_back(std::abs(s.imag() / row.s.imag() - 1));
      e.decay.push_back(std::abs(s.real() / row.s.real() - 1));
    }
    const std::string title = std::string("interface mode, ") + row.name;
    support::report(title + ", frequency", e.frequency);
    support::report(title + ", decay", e.decay);
    return e;
  }
  static void expect_rate(const Row& row) {
    const Errors e = measure(row);
    support::expect_order_down_to(1e-3, std::string("interface mode, ") + row.name + ", rate", e.rate, 1.5);
    EXPECT_LT(e.frequency.back(), 0.01);
    EXPECT_LT(e.decay.back(), 0.05);
  }
};

TEST_P(InterfaceModes, SlowestWave) { expect_rate(kViscous0); }
TEST_P(InterfaceModes, SecondWave) { expect_rate(kViscous1); }
TEST_P(InterfaceModes, OfASoftLayer) { expect_rate(kSoft0); }
TEST_P(InterfaceModes, UnderALayerOfATenthOfTheViscosity) { expect_rate(kThinner0); }
TEST_P(InterfaceModes, UnderALayerOfATenthOfTheViscositySecondWave) { expect_rate(kThinner1); }
TEST_P(InterfaceModes, UnderALayerOfFourTimesTheViscosity) { expect_rate(kThicker0); }

INSTANTIATE_TEST_SUITE_P(Solids, InterfaceModes, testing::ValuesIn(support::solids()), support::solid_name);

}  // namespace
}  // namespace softwall::time
