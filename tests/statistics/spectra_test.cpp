#include "solver/statistics/spectra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "solver/statistics/interface_height.hpp"
#include "solver/statistics/interface_moments.hpp"
#include "solver/statistics/interface_pairs.hpp"
#include "tests/statistics/flows.hpp"

namespace softwall::statistics {
namespace {

using namespace testing;

constexpr int kInterval = 2;

/// What rank 0 packed, on all ranks, as a checkpoint gives it.
Spectra::Packed shared(Spectra::Packed packed) {
  for (auto& [name, values] : packed) {
    auto size = values.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    values.resize(size);
    MPI_Bcast(values.data(), static_cast<int>(size), MPI_DOUBLE, 0, MPI_COMM_WORLD);
  }
  return packed;
}

TEST(Spectra, ContinueBitForBitFromWhatWasPackedAtAnyMoment) {
  for (const auto& physics : {scheduled(rigid_case()), scheduled(elastic_case())}) {
    time::Setup setup(physics, MPI_COMM_WORLD);
    Spectra whole(setup, kInterval);
    std::vector<std::unique_ptr<Spectra>> resumed;  // the n-th starts from what was packed after n steps
    advance_disturbed(setup, 130, [&](const time::State& s, double dt) {
      if (s.step % 13 == 1) {
        resumed.push_back(std::make_unique<Spectra>(setup, kInterval));
        resumed.back()->unpack(shared(whole.pack()));
      }
      whole.sample_step(s, dt);
      for (auto& spectra : resumed) spectra->sample_step(s, dt);
    });
    EXPECT_EQ(whole.pack().size(), physics.solid ? 7u : 4u);
    for (const auto& spectra : resumed) EXPECT_EQ(spectra->pack(), whole.pack());
  }
}

TEST(Spectra, DoNotDependOnTheNumberOfRanks) {
  for (const auto& physics : {scheduled(rigid_case()), scheduled(elastic_case())}) {
    std::vector<Spectra::Packed> packed;
    for (const MPI_Comm comm : {MPI_COMM_WORLD, MPI_COMM_SELF}) {
      time::Setup setup(physics, comm);
      Spectra spectra(setup, kInterval);
      advance_disturbed(setup, 30, [&](const time::State& s, double dt) { spectra.sample_step(s, dt); });
      packed.push_back(shared(spectra.pack()));
    }
    for (const auto& [name, alone] : packed[1]) {
      const auto& together = packed[0].at(name);
      ASSERT_EQ(together.size(), alone.size()) << name;
      EXPECT_GT(alone.size(), 1u);
      for (std::size_t n = 0; n < alone.size(); ++n)
        EXPECT_NEAR(together[n], alone[n], 1e-12 * std::max(1.0, std::abs(alone[n]))) << name << n;
    }
  }
}

const analysis::NamedArray& array(const std::vector<analysis::NamedArray>& arrays, const std::string& group,
                                  const std::string& name) {
  const auto found =
      std::ranges::find_if(arrays, [&](const auto& one) { return one.group == group && one.name == name; });
  if (found == arrays.end()) throw std::out_of_range(group + "/" + name);
  return *found;
}

TEST(Spectra, AreWrittenAsMeansOfBlocks) {
  time::Setup setup(scheduled(elastic_case()), MPI_COMM_WORLD);
  Spectra spectra(setup, kInterval);
  double variance = 0, since = 0, last = 0.01;
  advance_disturbed(setup, 7, [&](const time::State& s, double dt) {  // 0.01 .. 0.03
    spectra.sample_step(s, dt);
    if (s.step % kInterval != 0 || s.time <= 0.01) return;
    const auto shape =
        shape_of(heights_of_interface(s.material, setup.grid), setup.grid, setup.decomposition);
    variance += shape.rms * shape.rms * (s.time - last);
    since += s.time - last;
    last = s.time;
  });
  const auto arrays = spectra.arrays();
  if (setup.decomposition.all().rank() != 0) {
    EXPECT_TRUE(arrays.empty());
    return;
  }
  for (const auto& one : arrays) {
    const auto size =
        std::accumulate(one.shape.begin(), one.shape.end(), std::size_t{1}, std::multiplies<>());
    EXPECT_EQ(one.values.size(), size) << one.group << "/" << one.name;
  }
  ASSERT_EQ(array(arrays, "spectra", "weight").values.size(), 1u);
  EXPECT_NEAR(array(arrays, "spectra", "weight").values[0], since, 1e-15);
  EXPECT_DOUBLE_EQ(array(arrays, "spectra", "end").values[0], last);
  for (const std::string axis : {"x_eta", "z_eta"}) {
    const auto& of_height = array(arrays, "spectra", axis).values;
    EXPECT_NEAR(std::accumulate(of_height.begin(), of_height.end(), 0.0), variance / since, 1e-15);
  }
  EXPECT_NEAR(array(arrays, "interface", "eta2").values[0], variance / since, 1e-15);
  const auto& share = array(arrays, "interface", "share").values;
  EXPECT_NEAR(std::accumulate(share.begin(), share.end(), 0.0), 1, 1e-14);
  EXPECT_EQ(array(arrays, "spectra", "x_v").values[0], 0);
}

TEST(Spectra, AreNotThereWhereNoneAreAskedFor) {
  time::Setup setup(scheduled(elastic_case()), MPI_COMM_WORLD);
  Spectra none(setup, 0);
  advance_disturbed(setup, 4, [&](const time::State& s, double dt) { none.sample_step(s, dt); });
  EXPECT_TRUE(none.pack().empty());
  EXPECT_TRUE(none.arrays().empty());
}

/// Somebody sets run.spectra_steps to 0 for a while: what was sampled stays, and the time between does not
/// count.
TEST(Spectra, KeepWhatTheyHaveWhileNothingIsSampled) {
  time::Setup setup(scheduled(rigid_case()), MPI_COMM_WORLD);
  Spectra before(setup, kInterval), off(setup, 0), after(setup, kInterval);
  double counted = 0;
  advance_disturbed(setup, 90, [&](const time::State& s, double dt) {
    if (s.step == 31) off.unpack(shared(before.pack()));
    if (s.step == 61) {
      EXPECT_EQ(off.pack().size(), before.pack().size() - 1) << "all but the state of energy before";
      after.unpack(shared(off.pack()));
    }
    Spectra& now = s.step <= 30 ? before : s.step <= 60 ? off : after;
    now.sample_step(s, dt);
    const double begin = std::max(s.time - dt, setup.physics.statistics.start_time);
    if (s.step <= 30 || s.step > 60) counted += std::max(0.0, s.time - begin);
  });
  const auto arrays = after.arrays();
  if (setup.decomposition.all().rank() != 0) return;
  const auto& weight = array(arrays, "spectra", "weight").values;
  EXPECT_NEAR(std::accumulate(weight.begin(), weight.end(), 0.0), counted, 1e-9 * counted);
}

TEST(Spectra, BeginAnewWhereACheckpointHasNone) {
  time::Setup setup(scheduled(elastic_case()), MPI_COMM_WORLD);
  Spectra spectra(setup, kInterval);
  spectra.unpack({});
  advance_disturbed(setup, 6, [&](const time::State& s, double dt) { spectra.sample_step(s, dt); });
  EXPECT_FALSE(spectra.pack().empty());
}

/// Over a wave eta = A cos(k x - phase) with v, p and u in and out of phase with it.
TEST(InterfaceMoments, OfAWave) {
  time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  auto s = time::state_at_rest(setup);
  constexpr double kAmplitude = 0.1, k = 2 * kPi / 4;
  std::vector<double> heights(static_cast<std::size_t>(g.nx * g.nz));
  for_columns(g, 0, g.ny + 1, [&](int i, int j, int kz, double x, double) {
    const double middle = x + g.dx / 2;
    if (j < g.ny) heights[static_cast<std::size_t>(i + g.nx * kz)] = 1.9 + kAmplitude * std::cos(k * middle);
    if (j == g.ny_fluid) s.velocity.y(i, j, kz) = 0.2 * std::sin(k * middle);
    if (j < g.ny) s.pressure(i, j, kz) = 5 + (g.y_center[j] - 1) * std::cos(k * middle);
  });
  time::start(s, setup);
  const auto sample = interface_sample(interface_columns(s, heights, setup), setup);
  const auto moment = [&](std::string_view name) {
    const auto place = std::ranges::find(kInterfaceMoments, name) - kInterfaceMoments.begin();
    return sample[static_cast<std::size_t>(place)];
  };
  const double square = kAmplitude * kAmplitude;
  EXPECT_NEAR(moment("eta2"), square / 2, 1e-15);
  EXPECT_NEAR(moment("eta3"), 0, 1e-15);
  EXPECT_NEAR(moment("eta4"), square * square * 3 / 8, 1e-15);
  EXPECT_NEAR(moment("vv"), 0.02, 1e-15);
  EXPECT_NEAR(moment("pp"), 0.5, 1e-14);  // p' at y = 2 has amplitude 1
  EXPECT_NEAR(moment("v_eta"), 0, 1e-15);
  EXPECT_NEAR(moment("p_eta"), kAmplitude / 2, 1e-15);
  EXPECT_NEAR(moment("vp"), 0, 1e-15);
  EXPECT_NEAR(moment("uu"), 0, 1e-15);
}

TEST(InterfaceMoments, CountEveryColumnInItsBin) {
  time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  const auto s = rough_state(setup);
  std::vector<double> heights(static_cast<std::size_t>(g.nx * g.nz), 2);
  for_columns(g, 0, 1, [&](int i, int, int kz, double x, double) {
    if (x > 1.9) heights[static_cast<std::size_t>(i + g.nx * kz)] += 0.2;  // half of the columns
  });
  const auto sample = interface_sample(interface_columns(s, heights, setup), setup);
  const auto edges = height_bin_edges(g);
  EXPECT_DOUBLE_EQ(edges.front(), -0.5);
  EXPECT_DOUBLE_EQ(edges.back(), 0.5);
  for (std::size_t n = 0; n < kHeightBins; ++n) {
    const double share = sample[kInterfaceMoments.size() + n];
    const bool one_of_both =
        (edges[n] <= -0.1 && -0.1 < edges[n + 1]) || (edges[n] <= 0.1 && 0.1 < edges[n + 1]);
    EXPECT_NEAR(share, one_of_both ? 0.5 : 0, 1e-15) << n;
  }
}

TEST(InterfaceModes, AreThoseOfAWaveThatTravels) {
  time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  InterfaceModes modes(g);
  ASSERT_EQ(modes.modes(), 4u);
  time::State s;
  for (s.time = 0.5; s.time < 1; s.time += 0.2) {
    std::vector<double> heights(static_cast<std::size_t>(g.nx * g.nz));
    for_columns(g, 0, 1, [&](int i, int, int kz, double x, double z) {
      const double wave = 0.04 * std::cos(2 * kPi * 2 * (x + g.dx / 2) / 4 - 3 * s.time);
      heights[static_cast<std::size_t>(i + g.nx * kz)] = 2.05 + wave + 0.1 * std::cos(2 * kPi * z / 3);
    });
    modes.add(s, heights, setup);
  }
  ASSERT_EQ(modes.rows().size(), 3 * modes.row_length());
  for (std::size_t n = 0; n < 3; ++n) {
    const double* const row = &modes.rows()[n * modes.row_length()];
    EXPECT_NEAR(row[0], 0.5 + 0.2 * double(n), 1e-15);
    EXPECT_NEAR(row[3], 0.02 * std::cos(3 * row[0]), 1e-15);
    EXPECT_NEAR(row[4], -0.02 * std::sin(3 * row[0]), 1e-15);
    for (const int other : {1, 2, 5, 6}) EXPECT_NEAR(row[other], 0, 1e-15);
  }
  EXPECT_THROW(modes.unpack(std::vector<double>(10)), std::runtime_error);
}

TEST(InterfaceModes, AreDueOncePerInterval) {
  time::State s;
  int due = 0;
  constexpr double kStep = 0.01;
  for (int n = 1; n <= 1000; ++n) {
    s.time += kStep;
    due += InterfaceModes::is_due(s, kStep) ? 1 : 0;
  }
  EXPECT_EQ(due, 200);
}

}  // namespace
}  // namespace softwall::statistics
