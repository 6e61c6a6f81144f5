#include <gtest/gtest.h>

#include <functional>

#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"

// The shortest waves that a staggered grid holds change sign from cell to cell. A stress formed from averages
// would not see them; here they must be elastic waves like all others, and decay by viscosity.
namespace softwall::time {
namespace {

constexpr double kSmall = 1e-4;  // linear waves

int sign(int n) { return n % 2 == 0 ? 1 : -1; }

Physics box(SolidFormulation formulation) {
  Physics p = support::solid_box({12, 12, 0, 6 * support::world_size()});
  p.reynolds = 50;
  return support::formulated(p, formulation);
}

/// A solid box moving with the given pattern, ready to advance.
struct Shaken {
  using Pattern = std::function<double(int, int, int)>;
  Setup setup;
  State state = state_at_rest(setup);

  Shaken(SolidFormulation formulation, const Pattern& u, const Pattern& v, const Pattern& w)
      : setup(box(formulation), MPI_COMM_WORLD) {
    setup.bulk_velocity.reset();
    const auto& g = setup.grid;
    state.material = support::solid_everywhere(g, formulation);
    support::set_by_index(state.velocity.x, g, g.ny, u);
    support::set_by_index(state.velocity.y, g, g.ny, v);
    support::set_by_index(state.velocity.z, g, g.ny, w);
    make_solenoidal(state, setup);
  }
  double kinetic_energy() const {
    const auto &x = state.velocity.x, &y = state.velocity.y, &z = state.velocity.z;
    const double here = grid::sum_cells(grid::all_cells(setup.grid), [&](int i, int j, int k) {
      return x(i, j, k) * x(i, j, k) + y(i, j, k) * y(i, j, k) + z(i, j, k) * z(i, j, k);
    });
    return parallel::sum(setup.decomposition.all(), here);
  }
  /// Largest component of B - I anywhere.
  double deformation() const {
    double worst = 0;
    const auto include = [&](const grid::Field& f, double rest) {
      const auto deviation = [&](int i, int j, int k) { return std::abs(f(i, j, k) - rest); };
      worst = support::worse(worst, grid::max_cells(grid::all_cells(setup.grid), 0.0, deviation));
    };
    const auto& B = state.material.B;
    for (const grid::Field* f : {&B.xx, &B.yy, &B.zz}) include(*f, 1);
    for (const grid::Field* f : {&B.xy, &B.xz, &B.yz}) include(*f, 0);
    return support::worst(setup.decomposition.all(), worst);
  }
};

double none(int, int, int) { return 0; }

class Checkerboard : public testing::TestWithParam<SolidFormulation> {};

INSTANTIATE_TEST_SUITE_P(, Checkerboard, testing::ValuesIn(support::kBothFormulations),
                         [](const auto& test) { return support::name_of(test.param); });

/// A mode of one component that alternates in y (as no slip wants it), and perhaps in a direction across that
/// component, is an eigenmode of the box with kappa^2 = sum of 4 / d^2. Its velocity is that of a damped
/// oscillator, v = exp(-s t) (cos w t - s / w sin w t) of the start.
void expect_standing_wave(Shaken& shaken, const grid::Field& component, double kappa2) {
  auto& setup = shaken.setup;
  auto& s = shaken.state;
  const auto corner = [&] {
    return support::global_values(component, setup.grid, 1, setup.decomposition.all())[0];
  };
  const double start_value = corner(), damping = setup.viscosity * kappa2 / 2;
  const double w = std::sqrt(setup.physics.solid->G * kappa2 - damping * damping);
  ASSERT_NEAR(std::abs(start_value), kSmall, 1e-10);
  double largest_deformation = 0;
  for (int step = 0; step < 250; ++step) {  // two periods
    advance(s, setup, 0.05 / w);
    const double t = s.time;
    const double exact =
        start_value * std::exp(-damping * t) * (std::cos(w * t) - damping / w * std::sin(w * t));
    ASSERT_NEAR(corner(), exact, 0.01 * kSmall) << "at t = " << t;
    largest_deformation = support::worse(largest_deformation, shaken.deformation());
  }
  EXPECT_GT(largest_deformation, 0.5 * kSmall);
}

TEST_P(Checkerboard, OfUInYIsAStandingWave) {
  Shaken s(
      GetParam(), [](int, int j, int) { return kSmall * sign(j); }, none, none);
  const double dy = s.setup.grid.dy[0];
  expect_standing_wave(s, s.state.velocity.x, 4 / (dy * dy));
}

TEST_P(Checkerboard, OfUInYAndZIsAStandingWave) {
  Shaken s(
      GetParam(), [](int, int j, int k) { return kSmall * sign(j + k); }, none, none);
  const double dy = s.setup.grid.dy[0], dz = s.setup.grid.dz;
  expect_standing_wave(s, s.state.velocity.x, 4 / (dy * dy) + 4 / (dz * dz));
}

TEST_P(Checkerboard, OfWInYIsAStandingWave) {
  Shaken s(GetParam(), none, none, [](int, int j, int) { return kSmall * sign(j); });
  const double dy = s.setup.grid.dy[0];
  expect_standing_wave(s, s.state.velocity.z, 4 / (dy * dy));
}

TEST_P(Checkerboard, OfWInXAndYIsAStandingWave) {
  Shaken s(GetParam(), none, none, [](int i, int j, int) { return kSmall * sign(i + j); });
  const double dx = s.setup.grid.dx, dy = s.setup.grid.dy[0];
  expect_standing_wave(s, s.state.velocity.z, 4 / (dx * dx) + 4 / (dy * dy));
}

/// For patterns that the projection or the walls mix with others: what the projection leaves must turn into
/// deformation, come back, and be gone in the end.
void expect_felt_and_decaying(SolidFormulation formulation, const char* name, const Shaken::Pattern& u,
                              const Shaken::Pattern& v, const Shaken::Pattern& w) {
  SCOPED_TRACE(name);
  Shaken shaken(formulation, u, v, w);
  const double start_energy = shaken.kinetic_energy();
  ASSERT_GT(start_energy, 1e-3 * kSmall * kSmall * shaken.setup.grid.cells());
  ASSERT_EQ(shaken.deformation(), 0);
  double lowest = start_energy, recovered = 0, largest_deformation = 0;
  while (shaken.state.time < 10) {
    advance(shaken.state, shaken.setup, 0.02);
    const double energy = shaken.kinetic_energy();
    if (shaken.state.time < 1) {
      if (energy < lowest) recovered = 0;
      lowest = std::fmin(lowest, energy);
      recovered = support::worse(recovered, energy);
    }
    largest_deformation = support::worse(largest_deformation, shaken.deformation());
  }
  EXPECT_LT(lowest, 0.2 * start_energy);
  EXPECT_GT(recovered, 1.5 * lowest);
  EXPECT_GT(largest_deformation, 0.2 * kSmall);
  EXPECT_LT(shaken.kinetic_energy(), 0.01 * start_energy);
  EXPECT_LT(shaken.deformation(), 0.1 * largest_deformation);
}

TEST_P(Checkerboard, OfAnyComponentInAnyDirectionIsFeltAndDecays) {
  const auto x = [](int i, int, int) { return kSmall * sign(i); };
  const auto y = [](int, int j, int) { return kSmall * sign(j); };
  const auto z = [](int, int, int k) { return kSmall * sign(k); };
  const auto xy = [](int i, int j, int) { return kSmall * sign(i + j); };
  const auto xz = [](int i, int, int k) { return kSmall * sign(i + k); };
  const auto yz = [](int, int j, int k) { return kSmall * sign(j + k); };
  const auto xyz = [](int i, int j, int k) { return kSmall * sign(i + j + k); };
  expect_felt_and_decaying(GetParam(), "u in y", y, none, none);
  expect_felt_and_decaying(GetParam(), "u in z", z, none, none);
  expect_felt_and_decaying(GetParam(), "u in x and z", xz, none, none);
  expect_felt_and_decaying(GetParam(), "u in x and y", xy, none, none);
  expect_felt_and_decaying(GetParam(), "u in all", xyz, none, none);
  expect_felt_and_decaying(GetParam(), "v in x", none, x, none);
  expect_felt_and_decaying(GetParam(), "v in z", none, z, none);
  expect_felt_and_decaying(GetParam(), "v in x and y", none, xy, none);
  expect_felt_and_decaying(GetParam(), "v in y and z", none, yz, none);
  expect_felt_and_decaying(GetParam(), "v in all", none, xyz, none);
  expect_felt_and_decaying(GetParam(), "w in x", none, none, x);
  expect_felt_and_decaying(GetParam(), "w in y", none, none, y);
  expect_felt_and_decaying(GetParam(), "w in x and z", none, none, xz);
  expect_felt_and_decaying(GetParam(), "w in y and z", none, none, yz);
  expect_felt_and_decaying(GetParam(), "w in all", none, none, xyz);
}

}  // namespace
}  // namespace softwall::time
