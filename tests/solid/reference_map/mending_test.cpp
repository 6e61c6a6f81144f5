#include "solver/solid/reference_map/mending.hpp"

#include <gtest/gtest.h>

#include "solver/solid/reference_map/reference_map.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/no_follower.hpp"

namespace softwall::solid::reference_map {
namespace {

using support::Domain;

TEST(Damage, BeginsBeyondWhatALayerCanDoAndIsBounded) {
  EXPECT_EQ(damage_of(1, 1, 3), 0);
  EXPECT_EQ(damage_of(1, Real(0.91), 9), 0);
  EXPECT_EQ(damage_of(1, Real(1.09), 9), 0);
  EXPECT_NEAR(damage_of(1, Real(1.25), 3), 0.5, 1e-6);
  EXPECT_NEAR(damage_of(1, Real(0.75), 3), 0.5, 1e-6);
  EXPECT_NEAR(damage_of(Real(0.1), 1, 15), 0.5, 1e-6);
  EXPECT_NEAR(damage_of(1, Real(1.4), 3), kWhole, 1e-6);
  EXPECT_EQ(damage_of(1, Real(0.25), 3), kTorn);
  EXPECT_EQ(damage_of(1, 1, 31), kTorn);
  EXPECT_EQ(damage_of(1, -20, 3), kTorn);
  EXPECT_EQ(damage_of(1, 1, 1e6), kTorn);
  EXPECT_EQ(damage_of(0, -20, 1e6), 0) << "a cell without solid";
}

/// A layer whose displacement is `d_y` at one point, at rest in still fluid.
struct TornLayer {
  Domain d{MPI_COMM_WORLD, {8, 16, 8}, {}, support::faces(16)};
  Material m{d.grid};
  grid::VectorField still{d.grid, 1};
  ReferenceMap map{WenoWeights::kZ, d.grid, d.decomposition, d.halo};

  explicit TornLayer(double d_y) {
    m.formulation = SolidFormulation::kReferenceMap;
    m.surface_at_rest = 1.0;
    support::set_by_index(m.displacement.y, d.grid, d.grid.ny,
                          [=](int i, int j, int k) { return i == 3 && j == 12 && k == 4 ? d_y : 0.0; });
    support::NoFollower nobody;
    map.make_consistent(m, 0, nobody);
  }

  void substeps(int number, double dt) {
    for (int n = 0; n < number; ++n)
      map.transport(m, still, kRungeKutta3[std::size_t(n % 3)], dt, 0, &nobody);
  }

  [[nodiscard]] double displaced() const {
    return support::largest(
        support::global_values(m.displacement.y, d.grid, d.grid.ny, d.decomposition.all()));
  }
  [[nodiscard]] double torn() const {
    return parallel::sum(d.decomposition.all(), double(map.limited_cells()));
  }
};

/// With a step too short for transport and relaxation to do anything.
TEST(Mending, TakesATornPointBackToItsNeighbours) {
  const double dy = 2.0 / 16;
  TornLayer layer(3 * dy);
  layer.substeps(30, 1e-9);
  EXPECT_LT(layer.displaced(), 0.6 * dy);
  EXPECT_GT(layer.torn(), 1);
  const double before = layer.torn();
  layer.substeps(3, 1e-9);
  EXPECT_EQ(layer.torn(), before);
}

TEST(Mending, LeavesAHealthyMapAlone) {
  const double dy = 2.0 / 16;
  TornLayer layer(0.08 * dy);
  layer.substeps(6, 1e-12);
  EXPECT_NEAR(layer.displaced(), 0.08 * dy, 1e-10);
  EXPECT_EQ(layer.torn(), 0);
}

}  // namespace
}  // namespace softwall::solid::reference_map
