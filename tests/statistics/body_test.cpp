#include "solver/statistics/closed_box/body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/run_directory/statistics_checks.hpp"
#include "solver/statistics/statistics.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/closed_box/closed_box.hpp"
#include "tests/support/physics.hpp"

namespace softwall::statistics {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Body, IsTheDiscThatWasPutThere) {
  time::Setup setup(support::cavity_with_disc(64, 48), MPI_COMM_WORLD);
  const time::State s = time::closed_box_at_start(setup);
  const Body body = body_of(s.material.phi, setup.grid, setup.decomposition);
  const double h = setup.grid.dx;
  EXPECT_NEAR(body.centroid_x, 0.6, 1e-4);
  EXPECT_NEAR(body.centroid_y, 0.65, 1e-4);
  EXPECT_NEAR(body.area, kPi * 0.04, 1e-4);
  EXPECT_NEAR(body.x_min, 0.4, 0.3 * h);
  EXPECT_NEAR(body.x_max, 0.8, 0.3 * h);
  EXPECT_NEAR(body.y_min, 0.45, 0.3 * setup.grid.dy[0]);
  EXPECT_NEAR(body.y_max, 0.85, 0.3 * setup.grid.dy[0]);
  EXPECT_LT(body.width_cells, 1.5) << "sharp to a cell";
}

TEST(Body, WidthIsThatOfALinearRise) {
  time::Setup setup(support::cavity_with_disc(64, 64), MPI_COMM_WORLD);
  time::State s = time::closed_box_at_start(setup);
  const auto& g = setup.grid;
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const double r = std::hypot((g.x_begin + i + 0.5) * g.dx - 0.5, g.y_center[j] - 0.5);
      s.material.phi(i, j, 0) = std::clamp(0.5 + (0.25 - r) / (10 * g.dx), 0.0, 1.0);
    }
  }
  time::start(s, setup);
  EXPECT_NEAR(body_of(s.material.phi, g, setup.decomposition).width_cells, 8, 0.3);
}

TEST(Statistics, OfAClosedBoxAreTheSeriesOfItsBody) {
  Physics p = support::cavity_with_disc(32, 32);
  p.statistics = {.start_time = 0, .interval_steps = 5, .block_length = 1};
  time::Setup setup(p, MPI_COMM_WORLD);
  time::State s = time::closed_box_at_start(setup);
  Statistics statistics(setup);
  for (int n = 0; n < 20; ++n) {
    time::advance(s, setup, 0.005);
    statistics.sample_step(s, 0.005);
  }
  const auto blocks = statistics.blocks();
  EXPECT_TRUE(analysis::mistakes(blocks).empty());
  EXPECT_TRUE(blocks.profiles.empty());
  const Body body = body_of(s.material.phi, setup.grid, setup.decomposition);
  EXPECT_NEAR(blocks.series.at("area").back(), body.area, 1e-12);
  EXPECT_NEAR(blocks.series.at("centroid_x").back(), body.centroid_x, 0.05);
  EXPECT_GT(blocks.series.at("kinetic_energy").back(), 0);
  EXPECT_GT(blocks.series.at("elastic_energy").back(), 0);
}

}  // namespace
}  // namespace softwall::statistics
