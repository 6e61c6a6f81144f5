#include "solver/statistics/interface_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "solver/statistics/spectra.hpp"
#include "tests/statistics/flows.hpp"

namespace softwall::statistics {
namespace {

using namespace testing;

constexpr std::size_t kBins = kPairBins, kMiddle = kBins / 2;

/// Columns of this rank with v, p, eta as `value(x, z)` gives them.
template <class Value>
std::vector<InterfaceColumn> columns_with(const grid::Grid& g, const Value& value) {
  std::vector<InterfaceColumn> columns;
  for_columns(g, 0, 1, [&](int, int, int, double x, double z) {
    const auto [v, p, eta] = value(x, z);
    columns.push_back({9, v, 9, p, eta});  // u and w stand in no pair
  });
  return columns;
}

std::size_t place(std::size_t pair, std::size_t first, std::size_t second) {
  return (pair * kBins + first) * kBins + second;
}

TEST(InterfacePairs, BinsAreSymmetricAndFineAroundZero) {
  const time::Setup setup(elastic_case(), MPI_COMM_SELF);
  for (const auto& [name, range] : {std::pair{"v", 1.0}, {"p", 0.5}, {"eta", 0.5}}) {
    const auto edges = pair_bin_edges(name, setup.grid);
    ASSERT_EQ(edges.size(), kBins + 1);
    EXPECT_TRUE(std::ranges::is_sorted(edges));
    EXPECT_NEAR(edges.back(), range, 1e-15);
    for (std::size_t n = 0; n <= kBins; ++n) EXPECT_NEAR(edges[n], -edges[kBins - n], 1e-16);
    EXPECT_NEAR(edges[kMiddle + 1], 0.000609 * range, 1e-6 * range);
    for (std::size_t n = kMiddle + 1; n < kBins; ++n)
      EXPECT_GT(edges[n + 1] - edges[n], edges[n] - edges[n - 1]);
  }
  EXPECT_THROW((void)pair_bin_edges("u", setup.grid), std::out_of_range);
}

TEST(InterfacePairs, CountEveryColumnWhereBothOfItsValuesLie) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  const auto v = pair_bin_edges("v", g), p = pair_bin_edges("p", g), eta = pair_bin_edges("eta", g);
  const auto middle_of = [](const std::vector<double>& edges, std::size_t n) {
    return (edges[n] + edges[n + 1]) / 2;
  };
  const auto columns = columns_with(g, [&](double x, double z) {  // a quarter each by x and z
    const bool far = x > 1.9, side = z > 1.4;
    return std::array{middle_of(v, far ? 3 : 30), middle_of(p, side ? 44 : 5), far == side ? eta[35] : 0};
  });
  const auto sample = interface_pair_sample(columns, setup);
  std::vector<double> expected(kPairValues);
  for (const bool far : {false, true}) {
    for (const bool side : {false, true}) {
      const std::size_t of_v = far ? 3 : 30, of_p = side ? 44 : 5, of_eta = far == side ? 35 : kMiddle;
      expected[place(0, of_v, of_eta)] += 0.25;
      expected[place(1, of_p, of_eta)] += 0.25;
      expected[place(2, of_v, of_p)] += 0.25;
    }
  }
  ASSERT_EQ(sample.size(), expected.size());
  for (std::size_t n = 0; n < sample.size(); ++n) EXPECT_DOUBLE_EQ(sample[n], expected[n]) << n;
}

TEST(InterfacePairs, CountWhatLiesBeyondInTheLastBinOnItsSide) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto columns = columns_with(setup.grid, [](double, double) { return std::array{1e9, -0.6, 0.7}; });
  const auto sample = interface_pair_sample(columns, setup);
  EXPECT_DOUBLE_EQ(sample[place(0, kBins - 1, kBins - 1)], 1);
  EXPECT_DOUBLE_EQ(sample[place(1, 0, kBins - 1)], 1);
  EXPECT_DOUBLE_EQ(sample[place(2, kBins - 1, 0)], 1);
}

/// An old checkpoint has all sums but these: the others go on, these begin where it is.
TEST(InterfacePairs, BeginAnewWhereACheckpointHasNone) {
  time::Setup setup(scheduled(elastic_case()), MPI_COMM_WORLD);
  Spectra whole(setup, 2), resumed(setup, 2);
  double since = 0, begin = 0;
  advance_disturbed(setup, 14, [&](const time::State& s, double dt) {
    whole.sample_step(s, dt);
    if (s.step > 8) resumed.sample_step(s, dt);
    if (s.step == 8) {
      auto packed = whole.pack();  // sums of the interface are the same on all ranks
      std::erase_if(packed, [](const auto& one) {
        return one.first != "spectra_schedule" && !one.first.starts_with("interface");
      });
      ASSERT_EQ(packed.erase("interface_pairs"), 1u);
      resumed.unpack(packed);
      begin = s.time;
    }
    since = s.time - begin;
  });
  const auto continued = resumed.pack(), unbroken = whole.pack();
  EXPECT_EQ(continued.at("interface_moments"), unbroken.at("interface_moments"));
  EXPECT_NE(continued.at("interface_pairs"), unbroken.at("interface_pairs"));
  for (const auto& one : resumed.arrays()) {
    if (one.group != "interface_pairs") continue;
    const double sum = std::accumulate(one.values.begin(), one.values.end(), 0.0);
    if (one.name == "weight") {
      EXPECT_NEAR(sum, since, 1e-15);
    } else if (one.name.starts_with("share_")) {
      EXPECT_NEAR(sum, double(one.shape[0]), 1e-14) << one.name;
    }
  }
}

}  // namespace
}  // namespace softwall::statistics
