#include "solver/time/interface_wave.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <string>

#include "solver/statistics/wave_series.hpp"
#include "tests/support/flows.hpp"

namespace softwall::time {
namespace {

std::map<std::string, double> series_of(const State& s, const Setup& setup) {
  std::map<std::string, double> series;
  const auto kinds = statistics::wave_series_kinds();
  const auto values = statistics::wave_series_sample(s, setup);
  EXPECT_EQ(kinds.size(), values.size());
  for (std::size_t n = 0; n < kinds.size(); ++n) series[std::string(kinds[n].name)] = values[n];
  return series;
}

/// Displacement and velocity of the crest at the start: those of Re[a exp(s t)].
TEST(InterfaceWave, StartsAsTheModeOfLinearTheory) {
  for (const auto formulation : support::kBothFormulations) {
    time::Setup setup(support::formulated(support::interface_wave({32, 32, 16, 1}), formulation),
                      MPI_COMM_WORLD);
    const State s = interface_wave_at_start(setup);
    const WaveSpec wave = *setup.physics.wave;
    const auto series = series_of(s, setup);
    EXPECT_NEAR(series.at("wave_height"), wave.displacement, 0.01 * wave.displacement);
    const double scale = wave.displacement * wave.frequency;
    EXPECT_NEAR(series.at("wave_v"), -wave.decay * wave.displacement, 0.01 * scale);
    EXPECT_LT(pressure::max_divergence(s.velocity, setup.grid, setup.decomposition), 1e-13);
    EXPECT_GT(series.at("min_eigenvalue"), 1 - 20 * wave.displacement);
    EXPECT_LT(series.at("min_eigenvalue"), 1 - wave.displacement) << "the layer is deformed";
    EXPECT_LT(series.at("max_det_error"), 300 * wave.displacement * wave.displacement);
  }
}

/// A period later it is what it was, less its decay; nothing has driven the flow.
TEST(InterfaceWave, TurnsAndDecaysAtItsRate) {
  time::Setup setup(support::interface_wave({32, 32, 16, 1}), MPI_COMM_WORLD);
  State s = interface_wave_at_start(setup);
  const WaveSpec wave = *setup.physics.wave;
  const double period = 2 * std::numbers::pi / wave.frequency;
  const int steps = static_cast<int>(std::ceil(period / choose_time_step(s, setup).dt));
  for (int n = 0; n < steps; ++n) {
    advance(s, setup, period / steps);
    EXPECT_EQ(s.driving_gradient, 0);
  }
  const auto series = series_of(s, setup);
  EXPECT_NEAR(series.at("time"), period, 1e-12 * period);
  EXPECT_NEAR(series.at("wave_height") / wave.displacement, std::exp(-wave.decay * period), 0.03);
  EXPECT_GT(std::abs(series.at("wave_v_fluid")), 0);
  EXPECT_GT(std::abs(series.at("wave_v_solid")), 0);
}

TEST(InterfaceWave, IsTheSameOnAnyNumberOfRanks) {
  for (const auto formulation : support::kBothFormulations) {
    const Physics p = support::formulated(support::interface_wave({24, 24, 12, 1}), formulation);
    const auto after = [&](MPI_Comm comm) {
      time::Setup setup(p, comm);
      State s = interface_wave_at_start(setup);
      for (int n = 0; n < 20; ++n) advance(s, setup, 0.005);
      auto values = support::all_fields(s, setup);
      values.push_back(statistics::wave_series_sample(s, setup));
      return values;
    };
    const auto together = after(MPI_COMM_WORLD), alone = after(MPI_COMM_SELF);
    for (std::size_t f = 0; f < alone.size(); ++f)
      EXPECT_LT(support::largest_difference(together[f], alone[f]), 1e-11) << "field " << f;
  }
}

TEST(InterfaceWave, OnAStretchedGrid) {
  Physics p = support::interface_wave({32, 40, 22, 1});
  p.grid.stretching = 0.5;
  time::Setup setup(p, MPI_COMM_WORLD);
  const State s = interface_wave_at_start(setup);
  EXPECT_NEAR(series_of(s, setup).at("wave_height"), p.wave->displacement, 0.01 * p.wave->displacement);
}

}  // namespace
}  // namespace softwall::time
