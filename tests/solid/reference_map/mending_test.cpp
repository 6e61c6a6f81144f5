#include "solver/solid/reference_map/mending.hpp"

#include <gtest/gtest.h>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"
#include "solver/solid/reference_map/reference_map.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/no_follower.hpp"
#include "tests/support/solid_spec.hpp"

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
  EXPECT_NEAR(damage_of(1, Real(1.4), 3), kFullDamage, 1e-6);
  EXPECT_EQ(damage_of(1, Real(0.25), 3), kTorn);
  EXPECT_EQ(damage_of(1, 1, 31), kTorn);
  EXPECT_EQ(damage_of(1, -20, 3), kTorn);
  EXPECT_EQ(damage_of(1, 1, 1e6), kTorn);
  EXPECT_EQ(damage_of(0, -20, 1e6), 0) << "a cell without solid";
}

/// A layer whose displacement is `d_y` at one point, at rest in still fluid.
struct TornLayer {
  static constexpr int kRow = 12;
  Domain d{MPI_COMM_WORLD, {8, 16, 8}, {}, support::faces(16)};
  Material m{d.grid};
  grid::VectorField still{d.grid, 1};
  ReferenceMap map{support::solid_of(1), d.grid, d.decomposition, d.halo};
  support::NoFollower nobody;

  explicit TornLayer(double d_y) {
    m.formulation = SolidFormulation::kReferenceMap;
    m.surface_at_rest = 1.0;
    support::set_by_index(m.displacement.y, d.grid, d.grid.ny,
                          [=](int i, int j, int k) { return i == 3 && j == kRow && k == 4 ? d_y : 0.0; });
    map.make_consistent(m, 0, nobody);
  }

  void substeps(int number, double dt) {
    for (int n = 0; n < number; ++n)
      map.transport(m, still, kRungeKutta3[std::size_t(n % 3)], dt, 0, &nobody);
  }

  /// d_y of the point, the largest of its row.
  [[nodiscard]] double displaced() const {
    const auto y = m.displacement.y.view();
    return parallel::maximum(d.decomposition.all(),
                             grid::max_cells(grid::rows(d.grid, kRow, kRow + 1), 0.0,
                                             [=](int i, int j, int k) { return y(i, j, k); }));
  }
  [[nodiscard]] double torn() const {
    return parallel::sum(d.decomposition.all(), double(map.limited_cells()));
  }
};

TEST(Mending, TakesATornPointBackToItsNeighbours) {
  const double dy = 2.0 / 16;
  TornLayer layer(3 * dy);
  layer.substeps(30, 0.01);
  EXPECT_LT(layer.displaced(), 0.6 * dy);
  EXPECT_GT(layer.torn(), 1);
  const double before = layer.torn();
  layer.substeps(3, 0.01);
  EXPECT_EQ(layer.torn(), before);
}

/// In a given time a map is mended equally, however many steps the time is divided into.
TEST(Mending, DoesNotDependOnTheStep) {
  const double dy = 2.0 / 16, start = 3 * dy;
  TornLayer few(start), many(start);
  few.substeps(3, 4e-4);
  many.substeps(12, 1e-4);
  const double moved = start - few.displaced();
  EXPECT_GT(moved, 0.05 * start);
  EXPECT_NEAR(start - many.displaced(), moved, 0.05 * moved);
}

TEST(Mending, LeavesAHealthyMapAlone) {
  const double dy = 2.0 / 16;
  TornLayer layer(0.08 * dy);
  layer.substeps(6, 1e-3);
  EXPECT_NEAR(layer.displaced(), 0.08 * dy, 0.01 * dy);
  EXPECT_EQ(layer.torn(), 0);
}

}  // namespace
}  // namespace softwall::solid::reference_map
