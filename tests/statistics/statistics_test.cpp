#include "solver/statistics/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "solver/run_directory/statistics_checks.hpp"
#include "solver/statistics/interface_height.hpp"
#include "solver/statistics/profiles.hpp"
#include "solver/statistics/solid_health.hpp"
#include "tests/statistics/flows.hpp"

namespace softwall::statistics {
namespace {

using namespace testing;

TEST(Statistics, ContinueBitForBitFromWhatWasPackedAtAnyMoment) {
  constexpr int kSteps = 27;
  for (const auto& physics : {scheduled(rigid_case()), scheduled(elastic_case())}) {
    time::Setup setup(physics, MPI_COMM_WORLD);
    Statistics whole(setup);
    std::vector<Statistics> resumed;  // the n-th starts from what was packed after n steps
    advance_disturbed(setup, kSteps, [&](const time::State& s, double dt) {
      Statistics& next = resumed.emplace_back(setup);
      next.unpack(whole.pack());
      whole.sample_step(s, dt);
      for (auto& statistics : resumed) statistics.sample_step(s, dt);
    });
    EXPECT_GT(whole.blocks().blocks(), 2u);
    for (const auto& statistics : resumed) EXPECT_EQ(statistics.pack(), whole.pack());
  }
}

TEST(Statistics, IntegrateTheDrivingGradientOverEveryStepFromTheStartTimeOn) {
  time::Setup setup(scheduled(rigid_case()), MPI_COMM_WORLD);
  Statistics statistics(setup);
  double driven = 0, end = 0;
  advance_disturbed(setup, 28, [&](const time::State& s, double dt) {
    statistics.sample_step(s, dt);
    end = s.time;
    if (s.time > 0.01) driven += s.driving_gradient * std::min(dt, s.time - 0.01);
  });
  const auto blocks = statistics.blocks();
  ASSERT_EQ(blocks.blocks(), 4u);  // 0.01 .. 0.03 .. 0.05 .. 0.07 .. 0.084
  EXPECT_DOUBLE_EQ(blocks.start[1], 0.03);
  EXPECT_DOUBLE_EQ(blocks.end[1], 0.05);
  EXPECT_DOUBLE_EQ(blocks.end[3], end);  // the last block is still open: it ends where its last sample is
  // Steps end at 0.003 n: those up to 30, 48, 69, 84 thousandths.
  const std::vector<double> stepped = {0.020, 0.018, 0.021, 0.015};
  double integral = 0, sampled = 0;
  for (std::size_t b = 0; b < 4; ++b) {
    integral += blocks.series.at("driving_gradient")[b] * stepped[b];
    sampled += blocks.weight[b];
  }
  EXPECT_NEAR(integral, driven, 1e-14);
  EXPECT_NEAR(sampled, end - 0.01, 1e-14);  // the last step was sampled
}

TEST(Statistics, AreTheTimeWeightedMeansOfTheirSamples) {
  auto physics = rigid_case();
  physics.statistics = {.start_time = 0, .interval_steps = 3, .block_length = 1e3};
  time::Setup setup(physics, MPI_COMM_WORLD);
  Statistics statistics(setup);
  double shear = 0, since = 0, weight = 0;
  advance_disturbed(setup, 9, [&](const time::State& s, double dt) {
    statistics.sample_step(s, dt);
    since += dt;
    if (s.step % 3 != 0) return;
    shear += since * plane_means(s, setup)(kViscousStress, 0);
    weight += since;
    since = 0;
  });
  const auto blocks = statistics.blocks();
  ASSERT_EQ(blocks.blocks(), 1u);
  EXPECT_NEAR(blocks.weight[0], weight, 1e-14);
  EXPECT_NEAR(blocks.series.at("wall_shear_bottom")[0], shear / weight, 1e-14);
  EXPECT_EQ(blocks.series.at("wall_shear_bottom")[0], blocks.profiles.at("viscous_stress").values.front());
}

TEST(Statistics, OfAFlowDoNotDependOnTheNumberOfRanks) {
  for (const auto& physics : {scheduled(rigid_case()), scheduled(elastic_case())}) {
    std::vector<std::vector<double>> packed;
    for (const MPI_Comm comm : {MPI_COMM_WORLD, MPI_COMM_SELF}) {
      time::Setup setup(physics, comm);
      Statistics statistics(setup);
      advance_disturbed(setup, 24, [&](const time::State& s, double dt) { statistics.sample_step(s, dt); });
      packed.push_back(statistics.pack());
    }
    ASSERT_EQ(packed[0].size(), packed[1].size());
    for (std::size_t n = 0; n < packed[0].size(); ++n) {
      EXPECT_NEAR(packed[0][n], packed[1][n], 1e-10 * std::max(1.0, std::abs(packed[1][n]))) << n;
    }
  }
}

TEST(Statistics, AreTheSameOnEveryRank) {
  time::Setup setup(scheduled(elastic_case()), MPI_COMM_WORLD);
  Statistics statistics(setup);
  advance_disturbed(setup, 16, [&](const time::State& s, double dt) { statistics.sample_step(s, dt); });
  const auto here = statistics.pack();
  auto root = here;
  MPI_Bcast(root.data(), static_cast<int>(root.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
  EXPECT_EQ(here, root);
}

TEST(Statistics, MakeAValidStatisticsFile) {
  for (const auto& physics : {scheduled(rigid_case()), scheduled(elastic_case())}) {
    time::Setup setup(physics, MPI_COMM_WORLD);
    Statistics statistics(setup);
    EXPECT_EQ(analysis::mistakes(statistics.blocks()), std::vector<std::string>{});
    advance_disturbed(setup, 20, [&](const time::State& s, double dt) { statistics.sample_step(s, dt); });
    const auto blocks = statistics.blocks();
    EXPECT_EQ(analysis::mistakes(blocks), std::vector<std::string>{});
    EXPECT_EQ(blocks.profiles.count("elastic_stress"), physics.solid ? 1u : 0u);
    EXPECT_EQ(blocks.series.count("interface_rms"), physics.solid ? 1u : 0u);
    for (const double bulk : blocks.series.at("bulk_velocity")) EXPECT_NEAR(bulk, 1, 1e-13);
  }
}

TEST(Statistics, KeepThePeakOfTheInterfaceAndTheWorstOfTheSolid) {
  auto physics = scheduled(elastic_case());
  physics.statistics = {.start_time = 0, .interval_steps = 1, .block_length = 1e3};
  time::Setup setup(physics, MPI_COMM_WORLD);
  Statistics statistics(setup);
  double peak = 0, worst = 1, det = 0;
  advance_disturbed(setup, 12, [&](const time::State& s, double dt) {
    statistics.sample_step(s, dt);
    peak =
        std::max(peak, shape_of(heights_of_interface(s.material, setup.grid), setup.grid, setup.decomposition)
                           .max_deviation);
    const auto health = solid_health(s, setup);
    worst = std::min(worst, health.min_eigenvalue);
    det = std::max(det, health.max_det_error);
  });
  const auto blocks = statistics.blocks();
  EXPECT_EQ(blocks.series.at("interface_peak")[0], peak);
  EXPECT_EQ(blocks.series.at("min_eigenvalue")[0], worst);
  EXPECT_EQ(blocks.series.at("max_det_error")[0], det);
  EXPECT_LT(blocks.series.at("interface_max")[0], peak);
  EXPECT_LT(worst, 1);
  EXPECT_NEAR(blocks.series.at("solid_volume")[0], 6, 1e-12);
}

TEST(Statistics, OfAnotherCaseAreRefused) {
  time::Setup rigid(scheduled(rigid_case()), MPI_COMM_WORLD),
      elastic(scheduled(elastic_case()), MPI_COMM_WORLD);
  Statistics from(rigid), into(elastic);
  EXPECT_THROW(into.unpack(from.pack()), std::runtime_error);
  EXPECT_THROW(into.unpack({}), std::runtime_error);
}

}  // namespace
}  // namespace softwall::statistics
