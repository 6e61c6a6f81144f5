#include "solver/statistics/flow_spectra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

#include "tests/statistics/flows.hpp"
#include "tests/support/fields.hpp"

namespace softwall::statistics {
namespace {

using namespace testing;

constexpr int kFields = 4;

/// What FlowSpectra::whole() holds, on every rank.
class Whole {
 public:
  Whole(time::Setup& setup, const time::State& s, std::span<const double> heights) : setup_(setup) {
    const FlowSpectra spectra(setup.grid, setup.decomposition);
    modes_ = spectra.modes();
    const auto part = spectra.part_of(s, heights, setup.projection->poisson());
    EXPECT_EQ(part.size(), spectra.part_size());
    values_ = spectra.whole(part);
    EXPECT_EQ(values_.size(), setup.decomposition.all().rank() == 0 ? spectra.whole_size() : 0);
    values_.resize(spectra.whole_size());
    MPI_Bcast(values_.data(), static_cast<int>(values_.size()), MPI_DOUBLE, 0,
              setup.decomposition.all().get());
    EXPECT_EQ(spectra.part(values_), part);
  }
  /// E of a field (u, v, w, p) along an axis (x, z) in a row.
  [[nodiscard]] double operator()(int axis, int field, int mode, int row) const {
    const int before = axis == 0 ? 0 : kFields * modes_[0];
    const int place = (before + field * modes_[static_cast<std::size_t>(axis)] + mode) * setup_.grid.ny + row;
    return values_[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] int modes(int axis) const { return modes_[static_cast<std::size_t>(axis)]; }

 private:
  time::Setup& setup_;
  std::array<int, 2> modes_{};
  std::vector<double> values_;
};

/// Columns of one row of a field, on every rank: (nz, nx) less their mean.
std::vector<double> fluctuations(const time::Setup& setup, const grid::Field& field, int row) {
  const auto& g = setup.grid;
  const auto all = support::global_values(field, g, g.ny, setup.decomposition.all());
  std::vector<double> plane;
  for (int k = 0; k < g.nz_global; ++k) {
    for (int i = 0; i < g.nx_global; ++i)
      plane.push_back(all[static_cast<std::size_t>((k * g.ny + row) * g.nx_global + i)]);
  }
  double mean = 0;
  for (const double q : plane) mean += q / double(plane.size());
  for (double& q : plane) q -= mean;
  return plane;
}

/// Mean over the plane of q times q so many columns further along x (axis 0) or z.
double correlation(const std::vector<double>& q, const grid::Grid& g, int axis, int shift) {
  const int nx = g.nx_global, nz = g.nz_global;
  double sum = 0;
  for (int k = 0; k < nz; ++k) {
    for (int i = 0; i < nx; ++i) {
      const int other = axis == 0 ? k * nx + (i + shift) % nx : (k + shift) % nz * nx + i;
      sum += q[static_cast<std::size_t>(k * nx + i)] * q[static_cast<std::size_t>(other)];
    }
  }
  return sum / (double(nx) * nz);
}

TEST(FlowSpectra, AreTheCosineTransformsOfTheCorrelationsOfAnyField) {
  for (const int nx : {8, 9}) {
    for (const int nz : {6, 7}) {
      Physics physics = elastic_case();
      physics.grid.nx = nx;
      physics.grid.nz = nz;
      time::Setup setup(physics, MPI_COMM_WORLD);
      const auto& g = setup.grid;
      const auto s = rough_state(setup);
      const Whole spectra(setup, s, {});
      const std::array<const grid::Field*, kFields> fields{&s.velocity.x, &s.velocity.y, &s.velocity.z,
                                                           &s.pressure};
      for (int f = 0; f < kFields; ++f) {
        for (const int row : {1, 8, g.ny - 1}) {
          const auto q = fluctuations(setup, *fields[static_cast<std::size_t>(f)], row);
          for (const int axis : {0, 1}) {
            const int n = axis == 0 ? nx : nz;
            ASSERT_EQ(spectra.modes(axis), n / 2 + 1);
            for (int shift = 0; shift < n; ++shift) {
              double transform = 0;
              for (int m = 0; m < spectra.modes(axis); ++m)
                transform += spectra(axis, f, m, row) * std::cos(2 * kPi * m * shift / n);
              EXPECT_NEAR(transform, correlation(q, g, axis, shift), 1e-14) << f << row << axis << shift;
            }
          }
        }
      }
    }
  }
}

TEST(FlowSpectra, HaveTheHeightOfTheInterfaceInTheRowOfVOnTheWall) {
  time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  auto s = time::state_at_rest(setup);
  std::vector<double> heights(static_cast<std::size_t>(g.nx * g.nz));
  for_columns(g, 5, 6, [&](int i, int, int k, double x, double z) {
    const double wave = 0.3 * std::cos(2 * kPi * 2 * x / 4 + 0.4) * std::sin(2 * kPi * z / 3);
    heights[static_cast<std::size_t>(i + g.nx * k)] = 2.1 + wave;
    s.velocity.y(i, 5, k) = 7 + 2 * wave;
  });
  const Whole spectra(setup, s, heights);
  for (const int axis : {0, 1}) {
    for (int m = 0; m < spectra.modes(axis); ++m) {
      const double expected = m == (axis == 0 ? 2 : 1) ? 0.09 / 4 : 0;
      EXPECT_NEAR(spectra(axis, 1, m, 0), expected, 1e-15) << axis << m;
      EXPECT_NEAR(spectra(axis, 1, m, 5), 4 * expected, 1e-14) << axis << m;
      EXPECT_EQ(spectra(axis, 1, m, 6), 0);
    }
  }
}

/// The transforms lend their work arrays: a step after a sample has the bits of one without.
TEST(FlowSpectra, LeaveTheFlowAsItIs) {
  time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const FlowSpectra spectra(setup.grid, setup.decomposition);
  const auto after_two_steps = [&](bool sampled) {
    auto s = time::perturbed_laminar(setup);
    for (int n = 0; n < 2; ++n) {
      time::advance(s, setup, 0.003);
      if (sampled) static_cast<void>(spectra.part_of(s, {}, setup.projection->poisson()));
    }
    return support::global_values(s.velocity.x, setup.grid, setup.grid.ny, setup.decomposition.all());
  };
  EXPECT_EQ(after_two_steps(true), after_two_steps(false));
}

}  // namespace
}  // namespace softwall::statistics
