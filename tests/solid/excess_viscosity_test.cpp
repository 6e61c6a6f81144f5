#include "solver/solid/excess_viscosity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/support/linear_flow.hpp"
#include "tests/support/momentum_at_a_point.hpp"

// What a solid of another viscosity adds to the fluid's viscous force, over mu_f.
namespace softwall::solid {
namespace {

using support::Domain;

constexpr double kRatio = 10, kExcess = kRatio - 1;
constexpr Real kSolidFrom = 0.9;
constexpr int kI = 2, kJ = 3, kK = 1;

class ExcessViscosityTest : public testing::TestWithParam<double> {
 protected:
  Domain d{MPI_COMM_WORLD, {13, 10, 12}, {3, 1.5}, support::faces(10, 2, GetParam())};
  Material m{d.grid};
  InterfaceShare by_volume{kMeanByVolume, d.grid}, at_interface{kFluidAtFlatInterface, d.grid};

  template <class Value>
  void set_fraction(const Value& value) {
    support::set_by_index(m.phi, d.grid, d.grid.ny, value);
    fluid::fill_ghosts(m.phi, d.halo);
  }
  double total(const std::function<double(int, int, int)>& term) {
    return parallel::sum(d.decomposition.all(), grid::sum_cells(grid::all_cells(d.grid), term));
  }
};

TEST_P(ExcessViscosityTest, InSolidAloneIsTheFluidsForceTimesTheExcess) {
  const auto& g = d.grid;
  for (const double fraction : {0.95, 1.0}) {
    set_fraction([=](int, int, int) { return fraction; });
    const auto velocity = support::random_velocity(d, 3);
    ExcessViscosity excess(kRatio, kSolidFrom, by_volume, g);
    excess.renew(m, velocity, 0);
    const auto viscous = fluid::momentum_input(velocity, g, 1),
               inviscid = fluid::momentum_input(velocity, g, 0);
    const double more = kExcess * fraction;
    for (int k = 0; k < g.nz; ++k) {
      for (int j = 0; j < g.ny; ++j) {
        for (int i = 0; i < g.nx; ++i) {
          const auto expect = [&](const grid::Field& force, auto momentum) {
            const double exact = more * (momentum(viscous, i, j, k) - momentum(inviscid, i, j, k));
            ASSERT_NEAR(force(i, j, k), exact, 1e-11 * (1 + std::abs(exact)));
          };
          expect(excess.force().x, fluid::momentum_x);
          if (j > 0) expect(excess.force().y, fluid::momentum_y);
          expect(excess.force().z, fluid::momentum_z);
        }
      }
    }
  }
}

TEST_P(ExcessViscosityTest, OfALinearFractionInLinearFlowIsExact) {
  // d/dx_j [phi 2 D_ij] = 2 D_ij dphi/dx_j, whatever the flow's gradient. Only on a uniform grid are the
  // volume-weighted means of a linear phi exact; in y on a stretched grid they are first order.
  if (GetParam() > 0) GTEST_SKIP() << "exact on a uniform grid only";
  const auto& L = support::kGeneralFlow;
  const double slope[3] = {0.11, 0.23, -0.17};
  support::set_everywhere(m.phi, d.grid, support::kCenter, [&](double x, double y, double z) {
    return 0.1 + slope[0] * x + slope[1] * y + slope[2] * z;
  });
  const auto velocity = L.on(d.grid);
  ExcessViscosity excess(kRatio, 0, by_volume, d.grid);
  excess.renew(m, velocity, 0);
  double exact[3] = {};
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) exact[a] += kExcess * slope[b] * (L.gradient[a][b] + L.gradient[b][a]);
  }
  EXPECT_NEAR(excess.force().x(kI, kJ, kK), exact[0], 1e-12);
  EXPECT_NEAR(excess.force().y(kI, kJ, kK), exact[1], 1e-12);
  EXPECT_NEAR(excess.force().z(kI, kJ, kK), exact[2], 1e-12);
}

/// A solid at rest under shear knows nothing of the velocity of the fluid, and the stress on the interface is
/// the mean of that on both sides.
TEST_P(ExcessViscosityTest, AtTheInterfaceIsThatOfTheSolidsOwnShear) {
  const auto& g = d.grid;
  const int interface = 5;
  const double solid_x = -0.7, solid_z = 0.4;
  set_fraction([=](int, int j, int) { return j >= interface ? 1.0 : 0.0; });
  for (const double fluids : {0.0, 3.0}) {
    grid::VectorField velocity(g, 1);
    const auto shear = [&](double y, double own) {
      const double from = y - g.y_face[interface];
      return from > 0 ? own * from : fluids * std::sin(5 * y);
    };
    support::set_everywhere(velocity.x, g, support::kFaceX,
                            [&](double, double y, double) { return shear(y, solid_x); });
    support::set_everywhere(velocity.z, g, support::kFaceZ,
                            [&](double, double y, double) { return shear(y, solid_z); });
    ExcessViscosity excess(kRatio, kSolidFrom, by_volume, g);
    excess.renew(m, velocity, interface - 3);
    const double half = kExcess * g.upper_share[interface];  // stress on the interface over the shear
    const double above = (kExcess - half) * g.inv_dy[interface], below = half * g.inv_dy[interface - 1];
    const auto& f = excess.force();
    for (int k = 0; k < g.nz; ++k) {
      for (int i = 0; i < g.nx; ++i) {
        ASSERT_NEAR(f.x(i, interface, k), solid_x * above, 1e-11);
        ASSERT_NEAR(f.x(i, interface - 1, k), solid_x * below, 1e-11);
        ASSERT_NEAR(f.z(i, interface, k), solid_z * above, 1e-11);
        ASSERT_NEAR(f.z(i, interface - 1, k), solid_z * below, 1e-11);
        ASSERT_NEAR(f.x(i, interface + 1, k), 0, 1e-11);
        ASSERT_NEAR(f.x(i, interface - 2, k), 0, 1e-11);
        ASSERT_NEAR(f.y(i, interface, k), 0, 1e-11);
      }
    }
  }
}

/// A flat interface between two linear profiles: with what is lacking, the fluid's stress becomes that of its
/// own shear below the interface, or, where the grid puts more solid than fluid around the edge, a mean of
/// that and the solid's.
TEST_P(ExcessViscosityTest, TheFluidsOwnShearCountsAtTheInterface) {
  const auto& g = d.grid;
  const int interface = 5;
  const double fluids = 3, solids = -0.7;
  set_fraction([=](int, int j, int) { return j >= interface ? 1.0 : 0.0; });
  grid::VectorField velocity(g, 1);
  support::set_everywhere(velocity.x, g, support::kFaceX, [&](double, double y, double) {
    const double from = y - g.y_face[interface];
    return from * (from > 0 ? solids : fluids);
  });
  for (const double ratio : {1.0, kRatio}) {
    ExcessViscosity excess(ratio, kSolidFrom, at_interface, g);
    excess.renew(m, velocity, interface - 3);
    const double phi = g.upper_share[interface], s = std::max(0.0, 2 * phi - 1);
    const double lacks = (1 - s) * fluids + s * ratio * solids - ((1 - phi) * fluids + phi * solids);
    const auto x = excess.force().x.view();
    for (int k = 0; k < g.nz; ++k) {
      for (int i = 0; i < g.nx; ++i) {
        ASSERT_NEAR(x(i, interface - 1, k), lacks * g.inv_dy[interface - 1], 1e-11);
        ASSERT_NEAR(x(i, interface, k), ((ratio - 1) * solids - lacks) * g.inv_dy[interface], 1e-11);
        ASSERT_NEAR(x(i, interface + 1, k), 0, 1e-11);
      }
    }
  }
}

TEST_P(ExcessViscosityTest, MovesMomentumOnlyThroughTheUpperWall) {
  const auto& g = d.grid;
  set_fraction([=](int i, int j, int k) { return j < 4 ? 0 : (1 + support::noise(4, i, j, k)) / 2; });
  const auto velocity = support::random_velocity(d, 3);
  ExcessViscosity excess(kRatio, kSolidFrom, by_volume, g);
  excess.renew(m, velocity, 2);
  auto sums = excess.shear_stress_sums(m, velocity, 2);
  parallel::sum(d.decomposition.all(), sums);
  const auto& f = excess.force().x;
  for (int j = 2; j < g.ny; ++j) {
    const auto row = static_cast<std::size_t>(j);
    const double force =
        total([&](int i, int other, int k) { return other == j ? f(i, j, k) * g.dy[j] : 0.0; });
    EXPECT_NEAR(force, sums[row + 1] - sums[row], 1e-9) << j;
  }
  EXPECT_EQ(sums[2], 0);
  EXPECT_GT(std::abs(sums.back()), 1);
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, ExcessViscosityTest, testing::Values(0.0, 1.5));

}  // namespace
}  // namespace softwall::solid
