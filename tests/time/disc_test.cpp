#include "solver/time/closed_box/disc.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"

namespace softwall::time {
namespace {

constexpr double kPi = std::numbers::pi;

double area_of(const DiscSpec& disc, int nx, int ny) {
  const time::Setup setup(support::cavity(nx, ny), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  const solid::Material m = disc_at_rest(disc, g);
  double area = 0;
  for (const double phi : support::global_values(m.phi, g, g.ny, setup.decomposition.all())) {
    EXPECT_GE(phi, 0);
    EXPECT_LE(phi, 1 + 1e-14);
    area += phi * g.dx * g.dy[0];
  }
  return area;
}

TEST(Disc, HasItsAreaOnAnyGrid) {
  for (const auto& [nx, ny] : {std::pair{20, 16}, {33, 40}, {128, 128}}) {
    EXPECT_NEAR(area_of({.x = 0.52, .y = 0.47, .radius = 0.2}, nx, ny), kPi * 0.04, 2e-5);
  }
}

/// Zalesak's slot takes width times depth, less the two ends' segment of the circle below it.
TEST(Disc, LosesItsSlot) {
  const DiscSpec disc{.x = 0.5, .y = 0.75, .radius = 0.15, .slot_width = 0.05, .slot_depth = 0.25};
  const double r = disc.radius, half = disc.slot_width / 2;
  const double below_centre = half * std::sqrt(r * r - half * half) + r * r * std::asin(half / r);
  const double slot = below_centre + disc.slot_width * (disc.slot_depth - r);
  EXPECT_NEAR(area_of(disc, 64, 64), kPi * r * r - slot, 2e-5);
}

TEST(Disc, CellsAreWholeInsideEmptyOutsideAndHalvedByASlotsEdge) {
  const DiscSpec disc{.x = 0.5, .y = 0.5, .radius = 0.3, .slot_width = 0.1, .slot_depth = 0.3};
  EXPECT_NEAR(disc_fraction(disc, 0.5, 0.6, 0.01, 0.01), 1, 1e-13);
  EXPECT_EQ(disc_fraction(disc, 0.9, 0.9, 0.01, 0.01), 0);
  EXPECT_EQ(disc_fraction(disc, 0.5, 0.4, 0.01, 0.01), 0);
  EXPECT_NEAR(disc_fraction(disc, 0.545, 0.4, 0.01, 0.01), 0.5, 1e-12);
}

}  // namespace
}  // namespace softwall::time
