#include "solver/solid/reference_map/isochoric_extension.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/solid/reference_map/extrapolation.hpp"
#include "solver/solid/reference_map/strain.hpp"
#include "tests/support/fields.hpp"

namespace softwall::solid::reference_map {
namespace {

using support::Domain;

constexpr double kSurfaceAtRest = 1.0, kTwoPi = 2 * std::numbers::pi;

/// A wave of slope 1/2 over a layer that is sheared more and more towards its surface: the map
///   (x, y) -> (x - s(y), y - h(x - s(y))),
/// two shears one after the other, keeps areas exactly.
struct ShearedWave {
  double length;
  [[nodiscard]] static double shear(double y) { return 0.3 * (2 - y) * (2 - y); }
  [[nodiscard]] double rise(double x) const { return 0.5 * length / kTwoPi * std::sin(kTwoPi / length * x); }
  [[nodiscard]] double d_x(double y) const { return shear(y); }
  [[nodiscard]] double d_y(double x, double y) const { return rise(x - shear(y)); }
};

/// Keeps the displacement in the solid and leaves its continuation to the extension.
grid::VectorField displacement_of(const ShearedWave& wave, Domain& d) {
  grid::VectorField displacement(d.grid, 3);
  support::set_by_position(displacement.x, d.grid, support::kFaceX,
                           [&](double, double y, double) { return wave.d_x(y); });
  support::set_by_position(displacement.y, d.grid, support::kFaceY,
                           [&](double x, double y, double) { return wave.d_y(x, y); });
  return displacement;
}

void fill_ghosts(grid::VectorField& d, grid::Halo& halo, const Grid& g) {
  halo.fill({&d.x, &d.y, &d.z}, {0, g.ny + 1});
}

grid::Field copy_of(const grid::Field& field, const Grid& g) {
  grid::Field copy(g, 1);
  grid::for_each_cell({0, g.nx, 0, g.ny + 1, 0, g.nz},
                      [&](int i, int j, int k) { copy(i, j, k) = field(i, j, k); });
  return copy;
}

/// Largest |det A - 1| in the cells that the surface cuts.
double volume_error(const grid::VectorField& displacement, const Heights& eta, Domain& d) {
  const auto& g = d.grid;
  const Strain strain = strain_of(displacement, g);
  double worst = 0;
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 1; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        if (g.y_face[j] < eta(i, k) && g.y_face[j + 1] > eta(i, k))
          worst = support::worse(worst, std::abs(strain.center(i, j, k).determinant() - 1));
      }
    }
  }
  return support::worst(d.decomposition.all(), worst);
}

TEST(IsochoricExtension, KeepsTheVolumeOfCellsThatASteepSurfaceCuts) {
  Domain d(MPI_COMM_WORLD, {24, 80, 12}, {}, support::faces(80));
  const auto& g = d.grid;
  grid::VectorField displacement = displacement_of({g.length_x}, d);
  fill_ghosts(displacement, d.halo, g);
  Heights eta(g, 1);
  eta.find(displacement.y, kSurfaceAtRest);
  Extrapolation(g).extend(eta, 1, displacement);
  fill_ghosts(displacement, d.halo, g);
  const double straight = volume_error(displacement, eta, d);
  const grid::Field before = copy_of(displacement.y, g);

  IsochoricExtension(g).apply(eta, 1, displacement);
  fill_ghosts(displacement, d.halo, g);
  const double kept = volume_error(displacement, eta, d);
  EXPECT_GT(straight, 0.01);
  EXPECT_LT(kept, straight / 2);

  // The solid itself is left alone.
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j <= g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        if (g.y_face[j] < eta(i, k)) continue;
        EXPECT_EQ(displacement.y(i, j, k), before(i, j, k));
      }
    }
  }
}

/// A uniform gradient has the same det A everywhere: 1 here, so that nothing is to be mended.
TEST(IsochoricExtension, LeavesAUniformShearAlone) {
  Domain d(MPI_COMM_WORLD, {8, 16, 6}, {}, support::faces(16));
  const auto& g = d.grid;
  grid::VectorField displacement(g, 3);
  support::set_by_position(displacement.x, g, support::kFaceX,
                           [](double, double y, double) { return 0.4 * (y - 2); });
  fill_ghosts(displacement, d.halo, g);
  Heights eta(g, 1);
  eta.find(displacement.y, 1.03);
  IsochoricExtension(g).apply(eta, 1, displacement);
  EXPECT_LT(support::largest(support::global_values(displacement.y, g, g.ny, d.decomposition.all())), 1e-14);
}

}  // namespace
}  // namespace softwall::solid::reference_map
