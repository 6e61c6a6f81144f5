#include "solver/solid/reference_map/volume.hpp"

#include <gtest/gtest.h>

#include "solver/solid/reference_map/reference_map.hpp"
#include "solver/solid/reference_map/strain.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/no_follower.hpp"
#include "tests/support/solid_spec.hpp"

namespace softwall::solid::reference_map {
namespace {

using support::Domain;

struct Volume {
  double error = 0;   ///< largest |det A - 1| in full cells
  double height = 0;  ///< of the surface in one column
};

/// A layer above 1.0 at rest with the displacement `d_y(x, y)` kept by no flow for T.
template <class Displacement>
std::pair<Volume, Volume> left_alone(Domain& d, const Displacement& displacement, double T) {
  const auto& g = d.grid;
  Material m(g);
  m.formulation = SolidFormulation::kReferenceMap;
  m.surface_at_rest = 1.0;
  support::set_by_position(m.displacement.y, g, support::kFaceY,
                           [&](double x, double y, double) { return displacement(x, y); });
  const grid::VectorField still(g, 1);
  ReferenceMap map(support::solid_of(1), g, d.decomposition, d.halo);
  const auto look = [&] {
    const Strain strain = strain_of(m.displacement, g);
    Volume volume;
    for (int k = 0; k < g.nz; ++k) {
      for (int j = 0; j < g.ny; ++j) {
        for (int i = 0; i < g.nx; ++i) {
          if (m.phi(i, j, k) == 1)
            volume.error = support::worse(volume.error, std::abs(strain.center(i, j, k).determinant() - 1));
        }
      }
    }
    volume.error = support::worst(d.decomposition.all(), volume.error);
    double depth = 0;
    for (int j = 0; j < g.ny; ++j) depth += m.phi(0, j, 0) * g.dy[j];
    volume.height = g.height - depth;
    return volume;
  };
  support::NoFollower nobody;
  map.make_consistent(m, 0, nobody);
  const Volume before = look();
  const double dt = 0.01;
  for (int step = 0; step < T / dt; ++step) {
    for (const Stage& stage : kRungeKutta3) map.transport(m, still, stage, dt, 0, &nobody);
  }
  return {before, look()};
}

/// What relaxation adds to the rates of the displacement in a step of length dt.
grid::VectorField relaxation(const grid::Field& error, const Grid& g, double dt) {
  RelaxationSpeeds speeds(g);
  speeds.set(dt);
  const VolumeRelaxation out(speeds, error);
  grid::VectorField rate(g, 0);
  grid::for_each_cell(grid::all_cells(g), [&](int i, int j, int k) {
    rate.x(i, j, k) = -out.x(i, j, k);
    rate.y(i, j, k) = j > 0 ? -out.y(i, j, k) : 0;
    rate.z(i, j, k) = -out.z(i, j, k);
  });
  return rate;
}

/// A layer swollen or shrunk as a whole gives its volume back through the surface.
TEST(Volume, OfAFalselySwollenLayerComesBack) {
  for (const double swollen : {-0.05, 0.05}) {
    Domain d(MPI_COMM_WORLD, {6, 16, 6}, {}, support::faces(16, 2, swollen > 0 ? 1.0 : 0.0));
    const auto [before, after] = left_alone(
        d, [=](double, double y) { return swollen * (y - 2); }, 15);
    EXPECT_NEAR(before.error, std::abs(swollen), 1e-12);
    EXPECT_NEAR(before.height, 1 - swollen / (1 - swollen), 2e-3);
    EXPECT_LT(after.error, 0.1 * before.error);
    EXPECT_NEAR(after.height, 1, 0.1 * std::abs(before.height - 1));
  }
}

/// What changes sign from cell to cell goes at once; a d_y that keeps det A = 1 stays for ever, to the bit.
TEST(Volume, ErrorsOfOneCellDecayAndARealDisplacementStays) {
  Domain d(MPI_COMM_WORLD, {8, 16, 8}, {}, support::faces(16));
  const auto& g = d.grid;
  const auto rough = [&](double x, double y) {
    const int row = static_cast<int>(std::lround(y / g.dy[0]));
    return y > 1.3 && y < 1.9 ? (row % 2 == 0 ? 1e-3 : -1e-3) * std::cos(x) : 0.0;
  };
  const auto [before, after] = left_alone(d, rough, 2);
  EXPECT_LT(after.error, 0.05 * before.error);

  const grid::VectorField rate = relaxation(grid::Field(g, 1), g, 0.01);
  for (const grid::Field* f : {&rate.x, &rate.y, &rate.z})
    EXPECT_EQ(support::largest(support::global_values(*f, g, g.ny, d.decomposition.all())), 0);
}

/// Errors as large as a torn map's, alternating in all directions, with the step that the scheme allows at
/// most: still no growth.
TEST(Volume, IsStableAtAnyTimeStep) {
  Domain d(MPI_COMM_WORLD, {8, 16, 8}, {}, support::faces(16, 2, 1.2));
  const auto& g = d.grid;
  grid::Field error(g, 1);
  support::set_by_index(error, g, g.ny,
                        [](int i, int j, int k) { return (i + j + k) % 2 == 0 ? 1e-3 : -1e-3; });
  fluid::fill_ghosts(error, d.halo);
  for (const double dt : {1e-3, 1e-2, 1.0, 100.0}) {
    const grid::VectorField rate = relaxation(error, g, dt);
    for (int j = 1; j < g.ny - 1; ++j) {  // to first order, det A falls by the divergence of the displacement
      const double fall = dt * ((rate.x(2, j, 2) - rate.x(1, j, 2)) / g.dx +
                                (rate.y(1, j + 1, 2) - rate.y(1, j, 2)) / g.dy[j] +
                                (rate.z(1, j, 3) - rate.z(1, j, 2)) / g.dz);
      const double own = error(1, j, 2);
      EXPECT_GT(fall / own, 0) << dt;
      EXPECT_LT(fall / own, 2.51) << dt;
    }
  }
}

}  // namespace
}  // namespace softwall::solid::reference_map
