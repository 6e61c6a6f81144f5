#include <gtest/gtest.h>

#include <numbers>

#include "solver/solid/limiter.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/order.hpp"
#include "tests/support/physics.hpp"

// phi and B carried and stretched by velocities that are given: no momentum, exact answers known.
namespace softwall::solid {
namespace {

using support::Domain;
using support::kCenter;
using support::kEdgeXy;
using support::kEdgeXz;

constexpr double kPi = std::numbers::pi;

SolidSpec spec(WenoWeights weights = WenoWeights::kZ) {
  return {.G = 1, .viscosity_ratio = 1, .weno = weights, .threshold = 0.1, .min_eigenvalue = 1e-6};
}

/// Moves the material through time T in n steps; velocity(t) gives the field at the start of each substep.
template <class VelocityAt>
void carry(Solid& solid, Material& m, double T, int n, const VelocityAt& velocity_at) {
  const double dt = T / n;
  solid.start(m);
  for (int step = 0; step < n; ++step) {
    double t = step * dt;
    for (const Stage& stage : kRungeKutta3) {
      solid.transport(m, velocity_at(t), stage, dt);
      t += 2 * stage.alpha * dt;
    }
    solid.renew_band(m);
  }
}

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
  Solid solid(spec(), g, d.decomposition, d.halo);
  carry(solid, m, T, 20, [&](double) -> const grid::VectorField& { return velocity; });
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
  Solid solid(spec(weights), g, d.decomposition, d.halo);
  carry(solid, m, 1, 6 * n, [&](double) -> const grid::VectorField& { return velocity; });
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

struct Reversing {
  double returned = 0;     ///< largest |B - I| after the flow has come back
  double determinant = 0;  ///< largest |det B - 1| half way
};

double worst_determinant(const Material& m, const Domain& d) {
  double worst = 0;
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = 0; j < d.grid.ny; ++j) {
      for (int i = 0; i < d.grid.nx; ++i)
        worst = support::worse(worst, std::abs(tensor_at_center(m.B, i, j, k).determinant() - 1));
    }
  }
  return support::worst(d.decomposition.all(), worst);
}

double worst_deformation(const Material& m, const Domain& d) {
  const auto deviation = [&](const grid::Field& f, double rest) {
    return support::largest_error(f, d.grid, kCenter, d.decomposition,
                                  [=](double, double, double) { return rest; });
  };
  double worst = 0;
  for (const grid::Field* f : {&m.B.xx, &m.B.yy, &m.B.zz}) worst = support::worse(worst, deviation(*f, 1));
  for (const grid::Field* f : {&m.B.xy, &m.B.xz, &m.B.yz}) worst = support::worse(worst, deviation(*f, 0));
  return worst;
}

/// `unit` turns the solid for T, slowing to a halt at T/2 and turning back.
Reversing turn_and_return(Domain& d, const grid::VectorField& unit, int steps) {
  const double T = 1;
  grid::VectorField velocity(d.grid, 1);
  const auto at = [&](double t) -> const grid::VectorField& {
    const double s = std::cos(kPi * t / T);
    support::copy(unit, velocity);
    for (grid::Field* f : {&velocity.x, &velocity.y, &velocity.z}) {
      for (int k = -1; k <= d.grid.nz; ++k) {
        for (int j = -1; j <= d.grid.ny; ++j) {
          for (int i = -1; i <= d.grid.nx; ++i) (*f)(i, j, k) *= s;
        }
      }
    }
    return velocity;
  };
  Reversing result;
  Material m = support::solid_everywhere(d.grid);
  Solid solid(spec(), d.grid, d.decomposition, d.halo);
  carry(solid, m, T / 2, steps / 2, at);
  EXPECT_GT(worst_deformation(m, d), 0.3) << "the flow must deform the solid for the test to mean anything";
  result.determinant = worst_determinant(m, d);
  carry(solid, m, T / 2, steps / 2, [&](double t) -> const grid::VectorField& { return at(T / 2 + t); });
  result.returned = worst_deformation(m, d);
  return result;
}

/// The velocity of a stream function on the edges normal to its plane: discretely solenoidal.
Reversing vortex_in_xz(int n) {
  Domain d(MPI_COMM_WORLD, {n, 3, n}, {1, 1}, support::faces(3, 1));
  const auto& g = d.grid;
  const auto psi = [&](int i, int k) { return std::sin(2 * kPi * i / n) * std::sin(2 * kPi * k / n) / 20; };
  grid::VectorField unit(g, 1);
  support::set_by_index(unit.x, g, g.ny,
                        [&](int i, int, int k) { return (psi(i, k + 1) - psi(i, k)) / g.dz; });
  support::set_by_index(unit.z, g, g.ny,
                        [&](int i, int, int k) { return -(psi(i + 1, k) - psi(i, k)) / g.dx; });
  for (grid::Field* f : {&unit.x, &unit.z}) {  // walls that slip: nothing depends on y
    fluid::fill_ghosts(*f, d.halo);
  }
  return turn_and_return(d, unit, 2 * n);
}

Reversing vortex_in_xy(int n, double stretching) {
  Domain d(MPI_COMM_WORLD, {n, n, 3 * support::world_size()}, {1, 1}, support::faces(n, 1, stretching));
  const auto& g = d.grid;
  const auto psi = [&](int i, int j) {
    return std::pow(std::sin(kPi * g.y_face[j]), 2) * std::sin(2 * kPi * i / n) / 12;
  };
  grid::VectorField unit(g, 1);
  support::set_by_index(unit.x, g, g.ny,
                        [&](int i, int j, int) { return (psi(i, j + 1) - psi(i, j)) / g.dy[j]; });
  support::set_by_index(unit.y, g, g.ny,
                        [&](int i, int j, int) { return -(psi(i + 1, j) - psi(i, j)) / g.dx; });
  fluid::fill_ghosts(unit, {}, d.halo);
  return turn_and_return(d, unit, 2 * n);
}

void expect_second_order(const Reversing& coarse, const Reversing& fine) {
  EXPECT_GT(support::observed_order(coarse.determinant, fine.determinant), 1.75)
      << coarse.determinant << ' ' << fine.determinant;
  EXPECT_GT(support::observed_order(coarse.returned, fine.returned), 1.75)
      << coarse.returned << ' ' << fine.returned;
}

TEST(ReversingVortex, InXzReturnsToTheIdentityAndKeepsVolume) {
  expect_second_order(vortex_in_xz(24), vortex_in_xz(48));
}
TEST(ReversingVortex, InXyReturnsToTheIdentityAndKeepsVolume) {
  expect_second_order(vortex_in_xy(24, 0), vortex_in_xy(48, 0));
}
TEST(ReversingVortex, OnAStretchedGridToo) {
  expect_second_order(vortex_in_xy(24, 1.2), vortex_in_xy(48, 1.2));
}

}  // namespace
}  // namespace softwall::solid
