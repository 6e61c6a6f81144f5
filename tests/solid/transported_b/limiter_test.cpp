#include "solver/solid/transported_b/limiter.hpp"

#include <gtest/gtest.h>

#include "solver/solid/elastic_force.hpp"
#include "tests/support/physics.hpp"
#include "tests/support/round_off.hpp"
#include "tests/support/stretching_views.hpp"

namespace softwall::solid {
namespace {

using support::Domain;
using support::noise;

constexpr Real kFloor = 0.1;

class Limiter : public testing::TestWithParam<double> {
 protected:
  Domain d{MPI_COMM_WORLD, {14, 10, 13}, {}, support::faces(10, 2, GetParam())};
  InterfaceShare by_volume{kMeanByVolume, d.grid};

  /// Noise around the identity, large enough that many cells are not positive definite.
  Material rough() {
    const auto& g = d.grid;
    Material m(g);
    const auto fill = [&](grid::Field& f, int seed, double mean, double size) {
      support::set_by_index(f, g, g.ny + 1,
                            [=](int i, int j, int k) { return mean + size * noise(seed, i, j, k); });
    };
    fill(m.phi, 1, 0.5, 0.5);
    fill(m.B.xx, 2, 1, 0.5);
    fill(m.B.yy, 3, 1, 0.5);
    fill(m.B.zz, 4, 1, 0.5);
    fill(m.B.xy, 5, 0, 1.5);
    fill(m.B.xz, 6, 0, 1.5);
    fill(m.B.yz, 7, 0, 1.5);
    fill_ghosts(m);
    return m;
  }
  void fill_ghosts(Material& m) {
    for (grid::Field* f : {&m.phi, &m.B.xx, &m.B.yy, &m.B.zz, &m.B.xz}) fluid::fill_ghosts(*f, d.halo);
    d.halo.fill({&m.B.xy, &m.B.yz}, {0, d.grid.ny + 1});
  }
  ElasticForce force_of(const Material& m) const {
    ElasticForce force({1}, by_volume, d.grid);
    for (int k = 0; k < d.grid.nz; ++k) force.find(m, 0, k);
    return force;
  }
};

TEST_P(Limiter, BringsEveryEigenvalueToTheFloorAndCountsTheCells) {
  Material m = rough();
  const auto box = grid::all_cells(d.grid);
  std::int64_t below = 0;
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = 0; j < d.grid.ny; ++j) {
      for (int i = 0; i < d.grid.nx; ++i)
        below += min_eigenvalue(tensor_at_center(m.B, i, j, k)) < kFloor ? 1 : 0;
    }
  }
  ASSERT_GT(below, 0);
  EXPECT_EQ(keep_positive_definite(m.B, kFloor, box), below);
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = 0; j < d.grid.ny; ++j) {
      for (int i = 0; i < d.grid.nx; ++i)
        ASSERT_GE(min_eigenvalue(tensor_at_center(m.B, i, j, k)), kFloor - 1e-12);
    }
  }
}

TEST_P(Limiter, AppliedTwiceChangesNothingMore) {
  // A restart applies it again to a state that it has already seen: not one bit may change.
  Material m = rough();
  const auto box = grid::all_cells(d.grid);
  keep_positive_definite(m.B, kFloor, box);
  const auto whole = [&](const grid::Field& f) {
    return support::global_values(f, d.grid, d.grid.ny, d.decomposition.all());
  };
  const auto xx = whole(m.B.xx), yy = whole(m.B.yy), zz = whole(m.B.zz);
  EXPECT_EQ(keep_positive_definite(m.B, kFloor, box), 0);
  EXPECT_EQ(whole(m.B.xx), xx);
  EXPECT_EQ(whole(m.B.yy), yy);
  EXPECT_EQ(whole(m.B.zz), zz);
}

TEST_P(Limiter, LeavesGoodCellsAndAllShearAlone) {
  Material m = rough();
  const Material before = rough();
  keep_positive_definite(m.B, kFloor, grid::all_cells(d.grid));
  for (int k = 0; k < d.grid.nz; ++k) {
    for (int j = 0; j < d.grid.ny; ++j) {
      for (int i = 0; i < d.grid.nx; ++i) {
        const double shift = double(m.B.xx(i, j, k)) - before.B.xx(i, j, k);
        ASSERT_NEAR(double(m.B.yy(i, j, k)) - before.B.yy(i, j, k), shift, support::round_off(4));
        ASSERT_NEAR(double(m.B.zz(i, j, k)) - before.B.zz(i, j, k), shift, support::round_off(4));
        const bool good = min_eigenvalue(tensor_at_center(before.B, i, j, k)) > kFloor;
        ASSERT_TRUE(!good || shift == 0);
        ASSERT_EQ(m.B.xy(i, j, k), before.B.xy(i, j, k));
        ASSERT_EQ(m.B.xz(i, j, k), before.B.xz(i, j, k));
        ASSERT_EQ(m.B.yz(i, j, k), before.B.yz(i, j, k));
      }
    }
  }
}

TEST_P(Limiter, OnlyTouchesTheRowsOfTheBox) {
  Material m = rough();
  const Material before = rough();
  keep_positive_definite(m.B, kFloor, grid::rows(d.grid, 6, d.grid.ny));
  for (int j = 0; j < 6; ++j) EXPECT_EQ(m.B.xx(0, j, 0), before.B.xx(0, j, 0));
}

TEST_P(Limiter, MovesNothing) {
  // Its change of the force is a pure gradient, so after projection the velocity is the same.
  const auto& g = d.grid;
  Material m = rough();
  const auto project = [&](const grid::VectorField& force) {
    grid::VectorField velocity(g, 1);
    grid::for_each_cell(grid::all_cells(g), [&](int i, int j, int k) {
      velocity.x(i, j, k) = force.x(i, j, k);
      velocity.y(i, j, k) = force.y(i, j, k);
      velocity.z(i, j, k) = force.z(i, j, k);
    });
    fluid::fill_ghosts(velocity, {}, d.halo);
    grid::Field p(g, 1);
    pressure::Projection(g, d.decomposition, d.halo).project(velocity, p, kRungeKutta3[0], 1.0);
    std::vector<double> all;
    for (const grid::Field* f : {&velocity.x, &velocity.y, &velocity.z}) {
      const auto part = support::global_values(*f, g, g.ny, d.decomposition.all());
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  };
  const auto force_before = force_of(m);
  const auto free = project(force_before.now());
  ASSERT_GT(keep_positive_definite(m.B, kFloor, grid::all_cells(g)), 0);
  fill_ghosts(m);
  const auto force_after = force_of(m);
  const double changed = support::largest_difference(
      support::global_values(force_before.now().x, g, g.ny, d.decomposition.all()),
      support::global_values(force_after.now().x, g, g.ny, d.decomposition.all()));
  EXPECT_GT(changed, 0.1);  // the force itself does change
  EXPECT_LT(support::largest_difference(project(force_after.now()), free),
            support::round_off(4000) * support::largest(free));
}

INSTANTIATE_TEST_SUITE_P(UniformAndStretched, Limiter, testing::Values(0.0, 1.5));

}  // namespace
}  // namespace softwall::solid
