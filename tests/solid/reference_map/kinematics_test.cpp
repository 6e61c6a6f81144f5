#include <gtest/gtest.h>

#include <functional>

#include "solver/solid/reference_map/reference_map.hpp"
#include "solver/solid/reference_map/strain.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/no_follower.hpp"
#include "tests/support/order.hpp"
#include "tests/support/physics.hpp"
#include "tests/support/reversing_vortex.hpp"

// A displacement carried by velocities that are given: no momentum, exact answers known.
namespace softwall::solid::reference_map {
namespace {

using support::Domain;
using support::kCenter;

/// A layer over y >= at_rest.
Material layer(const Grid& g, double at_rest) {
  Material m(g);
  m.formulation = SolidFormulation::kReferenceMap;
  m.surface_at_rest = at_rest;
  return m;
}

using VelocityAt = std::function<const grid::VectorField&(double)>;

/// Moves the material through time T in n steps; velocity(t) gives the field at the start of each substep.
void carry(ReferenceMap& map, Material& m, double T, int n, const VelocityAt& velocity_at) {
  const double dt = T / n;
  support::NoFollower nobody;
  map.make_consistent(m, 0, nobody);
  for (int step = 0; step < n; ++step) {
    double t = step * dt;
    for (const Stage& stage : kRungeKutta3) {
      map.transport(m, velocity_at(t), stage, dt, 0, &nobody);
      t += 2 * stage.alpha * dt;
    }
  }
}

double worst_error(const grid::Field& f, const Domain& d, int j0, int j1, double value) {
  double worst = 0;
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = j0; j < j1; ++j) {
      for (int i = 0; i < d.grid.nx; ++i) worst = support::worse(worst, std::abs(f(i, j, k) - value));
    }
  }
  return support::worst(d.decomposition.all(), worst);
}

double worst_volume(const Material& m, const Domain& d) {
  const Strain strain = strain_of(m.displacement, d.grid);
  double worst = 0;
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = 0; j < d.grid.ny; ++j) {
      for (int i = 0; i < d.grid.nx; ++i) {
        if (m.phi(i, j, k) == 1)
          worst = support::worse(worst, std::abs(strain.center(i, j, k).determinant() - 1));
      }
    }
  }
  return support::worst(d.decomposition.all(), worst);
}

class Shear : public testing::TestWithParam<double> {
 protected:
  Domain d{MPI_COMM_WORLD, {12, 12, 7}, {}, support::faces(12, 2, GetParam())};
};

/// The layer hangs from a wall at rest; its lower part shears along with the fluid below it.
TEST_P(Shear, SimpleShearIsExactUpToTheSurface) {
  const auto& g = d.grid;
  const double rate_x = 0.8, rate_z = -0.5, T = 2;
  grid::VectorField velocity(g, 1);
  support::set_by_position(velocity.x, g, support::kFaceX,
                           [&](double, double y, double) { return rate_x * (g.height - y); });
  support::set_by_position(velocity.z, g, support::kFaceZ,
                           [&](double, double y, double) { return rate_z * (g.height - y); });
  fluid::fill_ghosts(velocity, {rate_x * g.height, 0}, d.halo);
  const double at_rest = 0.3 * g.y_face[5] + 0.7 * g.y_face[6];
  Material m = layer(g, at_rest);
  ReferenceMap map(support::solid_of(1), g, d.decomposition, d.halo);
  carry(map, m, T, 20, [&](double) -> const grid::VectorField& { return velocity; });
  const double a = -rate_x * T, c = -rate_z * T;
  EXPECT_LT(worst_error(m.B.xy, d, 5, g.ny + 1, a), 1e-12);  // on the wall too
  EXPECT_LT(worst_error(m.B.yz, d, 5, g.ny + 1, c), 1e-12);
  EXPECT_LT(worst_error(m.B.xx, d, 5, g.ny, 1 + a * a), 1e-12);
  EXPECT_LT(worst_error(m.B.zz, d, 5, g.ny, 1 + c * c), 1e-12);
  EXPECT_LT(worst_error(m.B.xz, d, 5, g.ny, a * c), 1e-12);
  EXPECT_LT(worst_error(m.B.yy, d, 5, g.ny, 1), 1e-12);
  EXPECT_LT(worst_error(m.phi, d, 0, 5, 0), 1e-15);
  EXPECT_LT(worst_error(m.phi, d, 5, 6, 0.3), 1e-12);
  EXPECT_LT(worst_error(m.phi, d, 6, g.ny, 1), 1e-15);
  EXPECT_EQ(map.limited_cells(), 0);
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, Shear, testing::Values(0.0, 1.5));

struct Reversing {
  double returned = 0;  ///< largest |d| after the flow has come back
  double volume = 0;    ///< largest |det A - 1| in full cells half way
};

/// `unit` turns the material, slowing to a halt at t = 1/2 and turning back.
Reversing turn_and_return(Domain& d, const grid::VectorField& unit, int steps, double at_rest) {
  support::ReversingVelocity velocity(unit, d.grid);
  Reversing result;
  Material m = layer(d.grid, at_rest);
  ReferenceMap map(support::solid_of(1), d.grid, d.decomposition, d.halo);
  carry(map, m, 0.5, steps / 2, [&](double t) -> const grid::VectorField& { return velocity.at(t); });
  const double deformed = support::worse(worst_error(m.B.xx, d, d.grid.ny / 2, d.grid.ny, 1),
                                         worst_error(m.B.zz, d, d.grid.ny / 2, d.grid.ny, 1));
  EXPECT_GT(deformed, 0.2) << "the flow must deform the solid for the test to mean anything";
  result.volume = worst_volume(m, d);
  carry(map, m, 0.5, steps / 2, [&](double t) -> const grid::VectorField& { return velocity.at(0.5 + t); });
  const auto& x = m.displacement;
  for (const grid::Field* f : {&x.x, &x.y, &x.z}) {
    for (int k = 0; k < d.grid.nz; ++k) {
      for (int j = 0; j < d.grid.ny; ++j) {
        for (int i = 0; i < d.grid.nx; ++i) {
          if (m.phi(i, j, k) == 1) result.returned = support::worse(result.returned, std::abs((*f)(i, j, k)));
        }
      }
    }
  }
  result.returned = support::worst(d.decomposition.all(), result.returned);
  return result;
}

Reversing vortex_in_xy(int n, double stretching, double at_rest) {
  Domain d(MPI_COMM_WORLD, {n, n, 3 * support::world_size()}, {1, 1}, support::faces(n, 1, stretching));
  return turn_and_return(d, support::vortex_in_xy(d), 2 * n, at_rest);
}

Reversing vortex_in_yz(int n, double stretching, double at_rest) {
  Domain d(MPI_COMM_WORLD, {3, n, n}, {1, 1}, support::faces(n, 1, stretching));
  return turn_and_return(d, support::vortex_in_yz(d), 2 * n, at_rest);
}

template <class Vortex>
void expect_return(const Vortex& vortex, double stretching, double at_rest, double least_order) {
  const Reversing coarse = vortex(24, stretching, at_rest), fine = vortex(48, stretching, at_rest);
  EXPECT_GT(support::observed_order(coarse.returned, fine.returned), least_order)
      << coarse.returned << ' ' << fine.returned;
  EXPECT_GT(support::observed_order(coarse.volume, fine.volume), least_order)
      << coarse.volume << ' ' << fine.volume;
}

TEST(ReversingVortex, InASolidBoxReturns) {
  for (const double stretching : {0.0, 1.2}) {
    expect_return(vortex_in_xy, stretching, 0, 1.75);
    expect_return(vortex_in_yz, stretching, 0, 1.75);
  }
}
/// The surface passes through the vortex: beside it gradients come from extrapolation, first order.
TEST(ReversingVortex, UnderASurfaceReturns) {
  for (const double stretching : {0.0, 1.2}) {
    expect_return(vortex_in_xy, stretching, 0.41, 0.75);
    expect_return(vortex_in_yz, stretching, 0.41, 0.75);
  }
}

}  // namespace
}  // namespace softwall::solid::reference_map
