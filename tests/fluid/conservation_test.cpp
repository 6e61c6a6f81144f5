#include <gtest/gtest.h>

#include "solver/fluid/momentum.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/momentum_at_a_point.hpp"

// What the convective and viscous terms may not do: create kinetic energy or momentum.
namespace softwall::fluid {
namespace {

using support::Domain;

/// Sum over the box of f(i, j, k) times the height of its control volume.
template <class F>
double integral(const Domain& d, bool y_face, const F& f) {
  const auto& g = d.grid;
  const auto box = grid::rows(g, y_face ? 1 : 0, g.ny);
  const double here = grid::sum_cells(
      box, [&](int i, int j, int k) { return f(i, j, k) * (y_face ? g.dy_face[j] : g.dy[j]); });
  return parallel::sum(d.decomposition.all(), here) * g.dx * g.dz;
}

class Conservation : public testing::TestWithParam<double> {
 protected:
  Domain d{MPI_COMM_WORLD, {14, 12, 13}, {}, support::faces(12, 2, GetParam())};
};

TEST_P(Conservation, ConvectionKeepsTheKineticEnergy) {
  const auto velocity = support::random_solenoidal_velocity(d, 3);
  const auto m = momentum_input(velocity, d.grid, 0);
  const double power_x =
      integral(d, false, [&](int i, int j, int k) { return m.u(i, j, k) * momentum_x(m, i, j, k); });
  const double power_y =
      integral(d, true, [&](int i, int j, int k) { return m.v(i, j, k) * momentum_y(m, i, j, k); });
  const double power_z =
      integral(d, false, [&](int i, int j, int k) { return m.w(i, j, k) * momentum_z(m, i, j, k); });
  const double size = integral(
      d, false, [&](int i, int j, int k) { return std::abs(m.u(i, j, k) * momentum_x(m, i, j, k)); });
  EXPECT_GT(size, 0.1);
  EXPECT_NEAR(power_x + power_y + power_z, 0, 1e-13 * size);
  EXPECT_NEAR(power_x, 0, 1e-13 * size);  // each is carried by a solenoidal flow, and so keeps its own
  EXPECT_NEAR(power_y, 0, 1e-13 * size);
  EXPECT_NEAR(power_z, 0, 1e-13 * size);
}

TEST_P(Conservation, ConvectionKeepsTheMomentumAlongTheWalls) {
  const auto velocity = support::random_solenoidal_velocity(d, 3);
  const auto m = momentum_input(velocity, d.grid, 0);
  const double size =
      integral(d, false, [&](int i, int j, int k) { return std::abs(momentum_x(m, i, j, k)); });
  EXPECT_NEAR(integral(d, false, [&](int i, int j, int k) { return momentum_x(m, i, j, k); }), 0,
              1e-13 * size);
  EXPECT_NEAR(integral(d, false, [&](int i, int j, int k) { return momentum_z(m, i, j, k); }), 0,
              1e-13 * size);
}

TEST_P(Conservation, ViscosityTakesMomentumOnlyThroughTheWalls) {
  const auto& g = d.grid;
  const double nu = 0.01;
  const auto velocity = support::random_solenoidal_velocity(d, 3);
  const auto m = momentum_input(velocity, g, nu);
  const auto wall = [&](int j) {  // viscous force of one wall on the flow above or below it
    const double here = grid::sum_cells(grid::rows(g, j, j + 1), [&](int i, int row, int k) {
      return m.nu * (m.u(i, row, k) - m.u(i, row - 1, k)) * g.inv_dy_face[row];
    });
    return parallel::sum(d.decomposition.all(), here) * g.dx * g.dz;
  };
  const double size =
      integral(d, false, [&](int i, int j, int k) { return std::abs(momentum_x(m, i, j, k)); });
  EXPECT_NEAR(integral(d, false, [&](int i, int j, int k) { return momentum_x(m, i, j, k); }),
              wall(g.ny) - wall(0), 1e-13 * size);
}

TEST_P(Conservation, ViscosityTakesKineticEnergy) {
  const auto velocity = support::random_solenoidal_velocity(d, 3);
  const auto viscous = momentum_input(velocity, d.grid, 1), inviscid = momentum_input(velocity, d.grid, 0);
  const double power = integral(d, false, [&](int i, int j, int k) {
    return viscous.u(i, j, k) * (momentum_x(viscous, i, j, k) - momentum_x(inviscid, i, j, k));
  });
  EXPECT_LT(power, 0);
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, Conservation, testing::Values(0.0, 1.8));

}  // namespace
}  // namespace softwall::fluid
