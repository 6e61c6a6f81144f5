#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/carried_solid.hpp"
#include "tests/support/order.hpp"
#include "tests/support/physics.hpp"

// phi and B carried and stretched by uniform shear and along straight lines; more in verification/.
namespace softwall::solid {
namespace {

using support::Domain;
using support::kCenter;
using support::kEdgeXy;
using support::kEdgeXz;

constexpr double kPi = std::numbers::pi;

class Shear : public testing::TestWithParam<double> {
 protected:
  Domain d{MPI_COMM_WORLD, {12, 8, 7}, {}, support::faces(8, 2, GetParam())};
};

TEST_P(Shear, SimpleShearIsExact) {
  const auto& g = d.grid;
  const double rate_x = 0.8, rate_z = -0.5, T = 2;
  grid::VectorField velocity(g, 1);
  support::set_by_position(velocity.x, g, support::kFaceX,
                           [=](double, double y, double) { return rate_x * y; });
  support::set_by_position(velocity.z, g, support::kFaceZ,
                           [=](double, double y, double) { return rate_z * y; });
  fluid::fill_ghosts(velocity, {0, rate_x * g.height}, d.halo);
  grid::for_each_cell(grid::rows(g, 0, 1), [&](int i, int, int k) {  // the top wall moves in z too
    velocity.z(i, g.ny, k) += 2 * rate_z * g.height;
  });
  d.halo.fill({&velocity.z});
  Material m = support::solid_everywhere(g);
  Solid solid(support::carried_spec(), g, d.decomposition, d.halo);
  support::carry(solid, m, T, 20, [&](double) -> const grid::VectorField& { return velocity; });
  const double a = rate_x * T, c = rate_z * T;
  const auto expect_uniform = [&](const grid::Field& f, int rows, double value) {
    for (const double b : support::global_values(f, g, rows, d.decomposition.all()))
      ASSERT_NEAR(b, value, 1e-12);
  };
  expect_uniform(m.B.xy, g.ny + 1, a);  // on the walls too
  expect_uniform(m.B.yz, g.ny + 1, c);
  expect_uniform(m.B.xx, g.ny, 1 + a * a);
  expect_uniform(m.B.zz, g.ny, 1 + c * c);
  expect_uniform(m.B.xz, g.ny, a * c);
  expect_uniform(m.B.yy, g.ny, 1);
  expect_uniform(m.phi, g.ny, 1);
  EXPECT_EQ(solid.limited_cells(), 0);
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, Shear, testing::Values(0.0, 1.5));

/// Error of phi and of B_xz after a smooth pattern has travelled once around the box along its diagonal.
double error_of_travel(int n, WenoWeights weights) {
  Domain d(MPI_COMM_WORLD, {n, 3, n}, {1, 1}, support::faces(3, 1));
  const auto& g = d.grid;
  grid::VectorField velocity(g, 1);
  support::set_by_index(velocity.x, g, g.ny, [](int, int, int) { return 1.0; });
  support::set_by_index(velocity.z, g, g.ny, [](int, int, int) { return -1.0; });
  fluid::fill_ghosts(velocity, {1, 1}, d.halo);
  grid::for_each_cell(grid::rows(g, 0, 1), [&](int i, int, int k) {
    velocity.z(i, -1, k) = velocity.z(i, g.ny, k) = -1;  // the walls travel along
  });
  d.halo.fill({&velocity.z});
  const auto pattern = [](double x, double, double z) {
    return 0.8 + 0.1 * std::sin(2 * kPi * x) + 0.1 * std::cos(2 * kPi * z + 0.4);
  };
  Material m = support::solid_everywhere(g);
  support::set_by_position(m.phi, g, kCenter, pattern);
  support::set_by_position(m.B.xz, g, kEdgeXz, pattern);
  Solid solid(support::carried_spec(weights), g, d.decomposition, d.halo);
  support::carry(solid, m, 1, 6 * n, [&](double) -> const grid::VectorField& { return velocity; });
  return support::worse(support::largest_error(m.phi, g, kCenter, d.decomposition, pattern),
                        support::largest_error(m.B.xz, g, kEdgeXz, d.decomposition, pattern));
}

TEST(Travel, SmoothPatternsArriveWithHighOrder) {
  // Fifth order in space; the third-order time error is kept below it by small steps.
  for (const auto weights : {WenoWeights::kJiangShu, WenoWeights::kZ}) {
    const double coarse = error_of_travel(16, weights), fine = error_of_travel(32, weights);
    EXPECT_GT(support::observed_order(coarse, fine), 3.9) << coarse << ' ' << fine;
    EXPECT_LT(fine, 1e-3);
  }
}

}  // namespace
}  // namespace softwall::solid
