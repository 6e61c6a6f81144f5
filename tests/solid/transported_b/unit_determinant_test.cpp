#include "solver/solid/transported_b/unit_determinant.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "solver/solid/transported_b/limiter.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/order.hpp"
#include "tests/support/physics.hpp"
#include "tests/support/round_off.hpp"

namespace softwall::solid {
namespace {

using support::Domain;

/// A shear of x with y that varies along x and z: B = (1 + s^2, s; s, 1) with s = s(x, z), det B = 1
/// everywhere; all of it so many times.
void set_sheared(Material& m, const Domain& d, double times) {
  const auto& g = d.grid;
  const double kx = 2 * std::numbers::pi / (g.dx * g.nx_global),
               kz = 2 * std::numbers::pi / (g.dz * g.nz_global);
  const auto shear = [=](double x, double z) { return std::sin(kx * x) * std::cos(kz * z); };
  const auto square = [=](double x, double, double z) { return times * (1 + shear(x, z) * shear(x, z)); };
  const auto one = [=](double, double, double) { return times; };
  const auto none = [](double, double, double) { return 0.0; };
  support::set_by_position(m.B.xx, g, support::kCenter, square);
  support::set_by_position(m.B.yy, g, support::kCenter, one);
  support::set_by_position(m.B.zz, g, support::kCenter, one);
  support::set_by_position(m.B.xy, g, support::kEdgeXy,
                           [=](double x, double, double z) { return times * shear(x, z); });
  support::set_by_position(m.B.xz, g, support::kEdgeXz, none);
  support::set_by_position(m.B.yz, g, support::kEdgeYz, none);
}

double largest(const Domain& d, const std::function<double(int, int, int)>& value) {
  double most = 0;
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = 0; j < d.grid.ny; ++j) {
      for (int i = 0; i < d.grid.nx; ++i) most = support::worse(most, value(i, j, k));
    }
  }
  return support::worst(d.decomposition.all(), most);
}

/// Largest change of a B whose determinant is 1 up to the error of interpolation between edges and centers.
double change_of_what_is_right(int n) {
  Domain d(MPI_COMM_WORLD, {n, 6, n}, {}, support::faces(6, 2, 0));
  Material m(d.grid), before(d.grid);
  set_sheared(m, d, 1);
  set_sheared(before, d, 1);
  restore_unit_determinant(m.B, d.grid, d.halo, 0, 1);
  EXPECT_EQ(m.B.xy(1, 1, 1), before.B.xy(1, 1, 1)) << "shear stays";
  return largest(d, [&](int i, int j, int k) {
    return std::max(std::abs(m.B.xx(i, j, k) - before.B.xx(i, j, k)),
                    std::abs(m.B.yy(i, j, k) - before.B.yy(i, j, k)));
  });
}

TEST(UnitDeterminant, LeavesWhatIsRightToSecondOrder) {
  const double coarse = change_of_what_is_right(16), fine = change_of_what_is_right(32);
  EXPECT_GT(support::observed_order(coarse, fine), 1.8) << coarse << ' ' << fine;
  EXPECT_LT(fine, 0.01);
}

TEST(UnitDeterminant, IsReachedWithinAFewSteps) {
  Domain d(MPI_COMM_WORLD, {16, 6, 16}, {}, support::faces(6, 2, 1.2));
  Material m(d.grid);
  set_sheared(m, d, 1.5);
  for (int step = 0; step < 10; ++step) restore_unit_determinant(m.B, d.grid, d.halo, 0, 1);
  const auto off = [&](int i, int j, int k) {
    return std::abs(tensor_at_center(m.B, i, j, k).determinant() - 1);
  };
  EXPECT_LT(largest(d, off), support::round_off(100));
}

TEST(UnitDeterminant, LeavesRowsBelowTheFirstAlone) {
  Domain d(MPI_COMM_WORLD, {8, 6, 8}, {}, support::faces(6, 2, 0));
  Material m(d.grid);
  set_sheared(m, d, 1.2);
  restore_unit_determinant(m.B, d.grid, d.halo, 3, 1);
  EXPECT_EQ(m.B.yy(3, 2, 3), Real(1.2));
  EXPECT_LT(m.B.yy(3, 3, 3), 1.15);
}

TEST(UnitDeterminant, IsRestoredInProportionToTheTime) {
  Domain d(MPI_COMM_WORLD, {8, 6, 8}, {}, support::faces(6, 2, 0));
  Material m(d.grid), whole(d.grid);
  for (Material* each : {&m, &whole}) set_sheared(*each, d, 1.1);
  restore_unit_determinant(m.B, d.grid, d.halo, 0, 0.25);
  restore_unit_determinant(whole.B, d.grid, d.halo, 0, 1);
  EXPECT_NEAR(1.1 - m.B.yy(2, 2, 2), 0.25 * (1.1 - whole.B.yy(2, 2, 2)), support::round_off(10));
  EXPECT_EQ(restored_share(0.5), 0.25);
  EXPECT_EQ(restored_share(100), 1);
}

/// A B that is no longer a strain is not blown up.
TEST(UnitDeterminant, IsNotAskedOfWhatIsNoStrain) {
  EXPECT_EQ(factor_of_normals({-2, -2, -2, 0, 0, 0}), 1);
  EXPECT_EQ(factor_of_normals({1, 1, 1, 3, 0, 0}), 1);
  EXPECT_EQ(factor_of_normals({1e3, 1e3, 1e3, 0, 0, 0}), 0.9);
  EXPECT_NEAR(factor_of_normals({1.02, 1.02, 1.02, 0, 0, 0}), 1 / 1.02, 1e-3);
}

}  // namespace
}  // namespace softwall::solid
