#include "solver/statistics/solid_health.hpp"

#include <gtest/gtest.h>

#include "tests/statistics/flows.hpp"

namespace softwall::statistics {
namespace {

using namespace testing;

TEST(SolidHealth, OfALayerAtRest) {
  time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  auto s = time::state_at_rest(setup.grid, SolidFormulation::kTransportedB);
  time::start(s, setup);
  const auto health = solid_health(s, setup);
  EXPECT_EQ(health.min_eigenvalue, 1);
  EXPECT_EQ(health.max_det_error, 0);
  EXPECT_NEAR(health.interface_width_cells, 0.8, 1e-13);
  EXPECT_NEAR(health.solid_volume, 0.5 * 4 * 3, 1e-13);
  const auto& g = setup.grid;
  EXPECT_NEAR(solid_cells(s, setup), double(g.nx_global) * (g.ny - g.ny_fluid) * g.nz_global, 1e-9);
}

TEST(SolidHealth, OfASimpleShearIsKnown) {
  // B = F F^T with F = [1 g; 0 1]: eigenvalues 1 and 1 + g^2/2 -+ g sqrt(1 + g^2/4), determinant 1.
  time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  auto s = time::state_at_rest(g, SolidFormulation::kTransportedB);
  const double shear = 0.8;
  for_columns(g, g.ny_fluid - 8, g.ny, [&](int i, int j, int k, double, double) {
    s.material.B.xx(i, j, k) = 1 + shear * shear;
    s.material.B.xy(i, j, k) = shear;
  });
  for_columns(g, g.ny, g.ny + 1,
              [&](int i, int j, int k, double, double) { s.material.B.xy(i, j, k) = shear; });
  time::start(s, setup);
  const auto health = solid_health(s, setup);
  EXPECT_NEAR(health.min_eigenvalue, 1 + shear * shear / 2 - shear * std::sqrt(1 + shear * shear / 4), 1e-13);
  EXPECT_NEAR(health.max_det_error, 0, 1e-14);
}

/// A layer with a reference map, its displacement d_x = shear (y - top), d_y = swollen (y - top).
SolidHealth of_a_map(double shear, double swollen) {
  auto physics = elastic_case();
  physics.solid->formulation = SolidFormulation::kReferenceMap;
  time::Setup setup(physics, MPI_COMM_WORLD);
  const auto& g = setup.grid;
  auto s = time::state_at_rest(setup);
  for_columns(g, 0, g.ny, [&](int i, int j, int k, double, double) {
    s.material.displacement.x(i, j, k) = shear * (g.y_center[j] - g.y_face[g.ny]);
    s.material.displacement.y(i, j, k) = swollen * (g.y_face[j] - g.y_face[g.ny]);
  });
  time::start(s, setup);
  return solid_health(s, setup);
}

TEST(SolidHealth, OfAShearedReferenceMapIsKnown) {
  const double shear = 0.8;
  const auto health = of_a_map(shear, 0);
  EXPECT_NEAR(health.min_eigenvalue, 1 + shear * shear / 2 - shear * std::sqrt(1 + shear * shear / 4), 1e-13);
  EXPECT_NEAR(health.max_det_error, 0, 1e-13);
  EXPECT_NEAR(health.solid_volume, 0.5 * 4 * 3, 1e-13);
  EXPECT_NEAR(health.interface_width_cells, 0.8, 1e-13);
}

TEST(SolidHealth, OfASwollenReferenceMapIsKnown) {
  // det A = 1 - s: F F^T has the determinant (1 - s)^-2, and the surface is where y - s (y - top) = 2.
  const double swollen = 0.2;
  const auto health = of_a_map(0, swollen);
  EXPECT_NEAR(health.max_det_error, 1 / (0.8 * 0.8) - 1, 1e-13);
  EXPECT_NEAR(health.solid_volume, 0.5 / 0.8 * 4 * 3, 1e-12);
  // Stretched in y, so shrunk in x and z; of equal eigenvalues half the digits are right.
  EXPECT_NEAR(health.min_eigenvalue, std::pow(0.8, 2.0 / 3), 1e-7);
}

TEST(SolidHealth, FindsTheOneWorstCellWhereverItIs) {
  for (int worst = 0; worst < 8 * 6; worst += 5) {
    time::Setup setup(elastic_case(), MPI_COMM_WORLD);
    const auto& g = setup.grid;
    auto s = time::state_at_rest(g, SolidFormulation::kTransportedB);
    for_columns(g, g.ny - 2, g.ny - 1, [&](int i, int j, int k, double, double) {
      const bool here = (g.z_begin + k) * g.nx_global + g.x_begin + i == worst;
      s.material.B.zz(i, j, k) = here ? 0.25 : 0.5;
    });
    time::start(s, setup);
    const auto health = solid_health(s, setup);
    EXPECT_NEAR(health.min_eigenvalue, 0.25, 1e-14);
    EXPECT_NEAR(health.max_det_error, 0.75, 1e-14);
  }
}

TEST(SolidHealth, DeterminantsOfPartlyFilledCellsDoNotCount) {
  time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  auto s = time::state_at_rest(g, SolidFormulation::kTransportedB);
  time::start(s, setup);
  for_columns(g, g.ny_fluid, g.ny_fluid + 1, [&](int i, int j, int k, double, double) {
    s.material.phi(i, j, k) = 0.5;
    s.material.B.xx(i, j, k) = 0.125;
  });
  const auto health = solid_health(s, setup);
  EXPECT_EQ(health.max_det_error, 0);
  EXPECT_NEAR(health.min_eigenvalue, 0.125, 1e-14);
}

TEST(SolidHealth, DoesNotDependOnTheNumberOfRanks) {
  time::Setup together(elastic_case(), MPI_COMM_WORLD), alone(elastic_case(), MPI_COMM_SELF);
  const auto here = solid_health(rough_state(together), together);
  const auto there = solid_health(rough_state(alone), alone);
  EXPECT_NEAR(here.min_eigenvalue, there.min_eigenvalue, 1e-13);
  EXPECT_NEAR(here.max_det_error, there.max_det_error, 1e-13);
  EXPECT_NEAR(here.interface_width_cells, there.interface_width_cells, 1e-12);
  EXPECT_NEAR(here.solid_volume, there.solid_volume, 1e-13);
}

}  // namespace
}  // namespace softwall::statistics
