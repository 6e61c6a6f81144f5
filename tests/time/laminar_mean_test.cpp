#include "solver/time/laminar_mean.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "solver/statistics/wave_series.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/interface_wave.hpp"
#include "tests/support/flows.hpp"

// Laminar flow under the layer that it has sheared, and a small wave on both.
namespace softwall::time {
namespace {

Physics driven_wave(support::Cells cells, SolidFormulation formulation, double displacement) {
  Physics p = support::formulated(support::interface_wave(cells), formulation);
  p.wave->mean_flow = MeanFlow::kLaminar;
  p.wave->displacement = displacement;
  return p;
}

double largest_change(const grid::Field& now, const grid::Field& before, const grid::Grid& g,
                      int first_row = 0) {
  double most = 0;
  for (int k = 0; k < g.nz; ++k) {
    for (int j = first_row; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i)
        most = std::max(most, std::abs(double(now(i, j, k)) - double(before(i, j, k))));
    }
  }
  return most;
}

TEST(LaminarMean, IsThatOfTheContinuumToSecondOrder) {
  double before = 0;
  for (const int n : {16, 32, 64}) {
    const time::Setup setup(driven_wave({8, n, n / 2, 1}, SolidFormulation::kReferenceMap, 1e-4),
                            MPI_COMM_WORLD);
    const LaminarMean mean(setup);
    const double exact = 3 / setup.physics.reynolds, error = std::abs(mean.gradient() / exact - 1);
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.4);
    }
    before = error;
    EXPECT_NEAR(mean.u(n / 2), 1.5, 10.0 / (n * n));
    EXPECT_EQ(mean.u(n), 0) << "in the layer";
    EXPECT_DOUBLE_EQ(mean.shear(2), -mean.gradient() / setup.physics.solid->G);
  }
  EXPECT_LT(before, 1e-3);
}

/// All but without a wave: hundreds of steps later everything is where it was, on a uniform and on a
/// stretched grid, and the driving gradient is the one foreseen.
TEST(LaminarMean, IsInEquilibrium) {
  for (const double stretching : {0.0, 0.5}) {
    Physics p = driven_wave({8, 24, stretching > 0 ? 14 : 12, 1}, SolidFormulation::kReferenceMap, 1e-14);
    p.grid.stretching = stretching;
    time::Setup setup(p, MPI_COMM_WORLD);
    State s = interface_wave_at_start(setup);
    const State start = interface_wave_at_start(setup);
    for (int n = 0; n < 300; ++n) advance(s, setup, 0.01);
    const double tolerance = 1e-11;
    EXPECT_LT(largest_change(s.velocity.x, start.velocity.x, setup.grid), tolerance);
    EXPECT_LT(largest_change(s.velocity.y, start.velocity.y, setup.grid), tolerance);
    const int in_layer = setup.grid.ny_fluid;
    EXPECT_LT(largest_change(s.material.displacement.x, start.material.displacement.x, setup.grid, in_layer),
              tolerance);
    EXPECT_NEAR(s.driving_gradient, LaminarMean(setup).gradient(), 1e-9);
  }
}

/// The wave starts with its crest above x = 0 and moves downstream from there.
TEST(LaminarMean, CarriesTheWaveDownstream) {
  for (const auto formulation : support::kBothFormulations) {
    time::Setup setup(driven_wave({32, 32, 16, 1}, formulation, 1e-4), MPI_COMM_WORLD);
    State s = interface_wave_at_start(setup);
    const auto height = [&] {
      const auto kinds = statistics::wave_series_kinds();
      const auto values = statistics::wave_series_sample(s, setup);
      std::complex<double> parts;
      for (std::size_t n = 0; n < kinds.size(); ++n) {
        if (kinds[n].name == std::string("wave_height")) parts += values[n];
        if (kinds[n].name == std::string("wave_height_sin")) parts += std::complex<double>(0, values[n]);
      }
      return parts;
    };
    EXPECT_LT(std::abs(height() - 1e-4), 1e-6);
    for (int n = 0; n < 20; ++n) advance(s, setup, 0.01);
    EXPECT_NEAR(std::arg(height()), 0.2 * setup.physics.wave->frequency, 0.15);
  }
}

}  // namespace
}  // namespace softwall::time
