#include "solver/statistics/interface_height.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "solver/parallel/reduce.hpp"
#include "tests/statistics/flows.hpp"

namespace softwall::statistics {
namespace {

using namespace testing;

/// Solid above eta(x, z), with a linear transition of the given width, the mean of each cell.
grid::Field solid_above(const grid::Grid& g, double width, const std::function<double(double, double)>& eta) {
  grid::Field phi(g, 3);
  const auto integral = [=](double above) {  // of clamp(1/2 + y / width, 0, 1) up to y = `above`
    const double share = std::clamp(0.5 + above / width, 0.0, 1.0);
    return width * share * share / 2 + std::max(0.0, above - width / 2);
  };
  for_columns(g, 0, g.ny, [&](int i, int j, int k, double x, double z) {
    const double bottom = g.y_face[j] - eta(x, z), top = g.y_face[j + 1] - eta(x, z);
    phi(i, j, k) = (integral(top) - integral(bottom)) / (top - bottom);
  });
  return phi;
}

InterfaceShape shape_of_solid(const grid::Field& phi, const time::Setup& setup) {
  return shape_of(heights_of_solid(phi, setup.grid), setup.grid, setup.decomposition);
}

TEST(Interface, ShapeOfAWavyInterface) {
  for (const double stretching : {0.0, 1.5}) {
    auto physics = elastic_case();
    physics.grid.stretching = stretching;
    const time::Setup setup(physics, MPI_COMM_WORLD);
    const auto phi = solid_above(setup.grid, 0.6, [&](double x, double z) {
      return 1.98 + 0.08 * std::cos(2 * kPi * x / 4) * std::cos(2 * kPi * z / 3);
    });
    const auto shape = shape_of_solid(phi, setup);
    EXPECT_NEAR(shape.mean, 1.98, 1e-13);
    EXPECT_NEAR(shape.rms, 0.08 / 2, 1e-13);
    EXPECT_NEAR(shape.max_deviation, 0.08, 1e-13);
  }
}

TEST(Interface, AFlatLayerLiesAtTheInterfaceOfTheCase) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto state = time::state_at_rest(setup.grid, SolidFormulation::kTransportedB);
  const auto shape = shape_of_solid(state.material.phi, setup);
  EXPECT_NEAR(shape.mean, 2, 1e-14);
  EXPECT_NEAR(shape.rms, 0, 1e-14);
  EXPECT_NEAR(shape.max_deviation, 0, 1e-14);
}

/// Where phi is the exact share of each cell, the depth of the solid is exact whatever rows the surface
/// crosses.
TEST(Interface, ShapeOfASharpInterface) {
  for (const double stretching : {0.0, 1.5}) {
    auto physics = elastic_case();
    physics.grid.stretching = stretching;
    const time::Setup setup(physics, MPI_COMM_WORLD);
    const auto& g = setup.grid;
    grid::Field phi(g, 3);
    for_columns(g, 0, g.ny, [&](int i, int j, int k, double x, double z) {
      const double eta = 1.98 + 0.2 * std::cos(2 * kPi * x / 4) * std::cos(2 * kPi * z / 3);
      phi(i, j, k) = std::clamp((g.y_face[j + 1] - eta) / g.dy[j], 0.0, 1.0);
    });
    const auto shape = shape_of_solid(phi, setup);
    EXPECT_NEAR(shape.mean, 1.98, 1e-13);
    EXPECT_NEAR(shape.rms, 0.2 / 2, 1e-13);
    EXPECT_NEAR(shape.max_deviation, 0.2, 1e-13);
  }
}

TEST(Interface, WidthInCells) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);  // dy = 1/8
  const auto& g = setup.grid;
  const auto sharp = time::state_at_rest(g, SolidFormulation::kTransportedB);
  EXPECT_NEAR(interface_width(sharp.material.phi, g, setup.decomposition), 0.8, 1e-13);
  grid::Field wide(g, 3);  // linear from center to center
  for_columns(g, 0, g.ny, [&](int i, int j, int k, double x, double) {
    wide(i, j, k) = std::clamp(0.5 + (g.y_center[j] - 1.5 - 0.05 * std::sin(kPi * x / 2)) / 1.5, 0.0, 1.0);
  });
  EXPECT_NEAR(interface_width(wide, g, setup.decomposition), 0.8 * 1.5 * 8, 1e-12);
}

TEST(Interface, IsFoundFromTheSolidSide) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  auto phi = solid_above(g, 0.5, [](double, double) { return 1.875; });
  for_columns(g, 3, 5, [&](int i, int j, int k, double, double) { phi(i, j, k) = 1; });  // a drop of solid
  EXPECT_NEAR(shape_of_solid(phi, setup).mean, 1.875, 1e-13);
}

TEST(Interface, ColumnsWithoutACrossingEndAtAWall) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  grid::Field phi(g, 3);
  EXPECT_NEAR(shape_of_solid(phi, setup).mean, 2.5, 1e-14);
  for_columns(g, 0, g.ny, [&](int i, int j, int k, double, double) { phi(i, j, k) = 1; });
  EXPECT_NEAR(shape_of_solid(phi, setup).mean, 0, 1e-14);
}

TEST(Interface, AValueEqualToTheLevelIsSolid) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  grid::Field phi(g, 3);
  for_columns(g, 10, g.ny, [&](int i, int j, int k, double, double) { phi(i, j, k) = j == 10 ? 0.5 : 1; });
  for (const double row : crossing_rows(phi, 0.5, g)) EXPECT_NEAR(row, 10, 1e-14);
}

/// A wave so small that nothing but traces cross the face on which the interface lay.
TEST(Interface, MovesAsFarAsTheMaterialHoweverLittle) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  const auto phi = solid_above(g, 1e-9, [](double x, double) { return 2 + 1e-5 * std::sin(kPi * x / 2); });
  EXPECT_NEAR(shape_of_solid(phi, setup).rms, 1e-5 / std::sqrt(2), 1e-11);
}

/// The surface of a reference map is known over the centers of columns, however few there are to a wave.
TEST(Interface, OfAReferenceMapIsTheMaterialSurface) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  auto state = time::state_at_rest(g, SolidFormulation::kReferenceMap);
  const auto raised = [&](double x, double z) {
    return 0.03 * std::cos(2 * kPi * x / 4) * std::cos(2 * kPi * z / 3);
  };
  auto& d = state.material.displacement.y;
  for_columns(g, 0, g.ny + 1, [&](int i, int j, int k, double x, double z) { d(i, j, k) = raised(x, z); });
  const auto heights = heights_of_interface(state.material, g);
  for_columns(g, 0, 1, [&](int i, int, int k, double x, double z) {
    EXPECT_NEAR(heights[static_cast<std::size_t>(i + g.nx * k)], 2 + raised(x, z), 1e-13) << i << ' ' << k;
  });
}

TEST(Interface, DustDoesNotCount) {
  const time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  auto phi = solid_above(g, 0.5, [](double, double) { return 1.875; });
  for_columns(g, 0, 8, [&](int i, int j, int k, double, double) { phi(i, j, k) += 0.01; });
  EXPECT_NEAR(shape_of_solid(phi, setup).mean, 1.875, 0.011 / 8);
}

}  // namespace
}  // namespace softwall::statistics
