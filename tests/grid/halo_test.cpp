#include "solver/grid/halo.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/fields.hpp"

namespace softwall::grid {
namespace {

using support::Domain;

constexpr Real kUntouched = -1;

Real label(int i, int j, int k, int which) { return 1 + i + 100 * (j + 10) + 10000 * k + 1000000 * which; }

int wrapped(int index, int n) { return (index % n + n) % n; }

/// Interior cells labelled by global index in all rows the field has, ghost columns not set.
Field labelled(const Grid& g, int ghost, int which) {
  Field f(g, ghost);
  for (int k = -ghost; k < g.nz + ghost; ++k) {
    for (int j = -ghost; j < g.ny + ghost; ++j) {
      for (int i = -ghost; i < g.nx + ghost; ++i) {
        const bool own = i >= 0 && i < g.nx && k >= 0 && k < g.nz;
        f(i, j, k) = own ? label(g.x_begin + i, j, g.z_begin + k, which) : kUntouched;
      }
    }
  }
  return f;
}

void expect_filled(const Field& f, const Grid& g, int which, RowSpan rows) {
  const int h = f.ghost();
  for (int k = -h; k < g.nz + h; ++k) {
    for (int j = -h; j < g.ny + h; ++j) {
      for (int i = -h; i < g.nx + h; ++i) {
        const bool own = i >= 0 && i < g.nx && k >= 0 && k < g.nz;
        const bool filled = own || (j >= rows.j0 && j < rows.j1);
        const Real expected =
            label(wrapped(g.x_begin + i, g.nx_global), j, wrapped(g.z_begin + k, g.nz_global), which);
        ASSERT_EQ(f(i, j, k), filled ? expected : kUntouched) << i << ' ' << j << ' ' << k;
      }
    }
  }
}

TEST(Halo, FillsFacesEdgesAndCornersFromAnyRank) {
  for (const int nx : {12, 13}) {
    for (const int nz : {6, 7}) {
      Domain d(MPI_COMM_WORLD, {nx, 5, nz}, {}, support::faces(5));
      for (const int ghost : {1, 2, 3}) {
        Field f = labelled(d.grid, ghost, 0);
        d.halo.fill({&f});
        expect_filled(f, d.grid, 0, {-ghost, d.grid.ny + ghost});
      }
    }
  }
}

TEST(Halo, OneCellInZIsItsOwnNeighbour) {
  Domain d(MPI_COMM_WORLD, {19, 5, 1}, {}, support::faces(5));
  for (const int ghost : {1, 2, 3}) {
    Field f = labelled(d.grid, ghost, 0);
    d.halo.fill({&f});
    expect_filled(f, d.grid, 0, {-ghost, d.grid.ny + ghost});
  }
}

TEST(Halo, RepeatsTheColumnsAtWallsInX) {
  for (const int nz : {1, 7}) {
    Domain d(MPI_COMM_WORLD, {20, 5, nz}, {}, support::faces(5));
    const Grid& g = d.grid;
    Halo halo(d.decomposition, true);
    for (const int ghost : {1, 3}) {
      Field f = labelled(g, ghost, 0);
      halo.fill({&f});
      for (int k = -ghost; k < g.nz + ghost; ++k) {
        for (int i = -ghost; i < g.nx + ghost; ++i) {
          const int column = std::clamp(g.x_begin + i, 0, g.nx_global - 1);
          ASSERT_EQ(f(i, 2, k), label(column, 2, wrapped(g.z_begin + k, nz), 0)) << i << ' ' << k;
        }
      }
    }
  }
}

TEST(Halo, FillsSeveralFieldsAtOnceAndOnlyTheRowsAskedFor) {
  Domain d(MPI_COMM_WORLD, {12, 5, 7}, {}, support::faces(5));
  Field a = labelled(d.grid, 2, 0), b = labelled(d.grid, 2, 1), c = labelled(d.grid, 2, 2);
  d.halo.fill({&a, &b, &c}, {1, 4});
  expect_filled(a, d.grid, 0, {1, 4});
  expect_filled(b, d.grid, 1, {1, 4});
  expect_filled(c, d.grid, 2, {1, 4});
}

TEST(Halo, MayBeUsedAgainWithMoreFields) {
  Domain d(MPI_COMM_WORLD, {12, 5, 7}, {}, support::faces(5));
  Field a = labelled(d.grid, 1, 0);
  d.halo.fill({&a});
  Field b = labelled(d.grid, 3, 1), c = labelled(d.grid, 3, 2);
  d.halo.fill({&b, &c});
  expect_filled(b, d.grid, 1, {-3, d.grid.ny + 3});
  expect_filled(c, d.grid, 2, {-3, d.grid.ny + 3});
}

TEST(Halo, KeepsWidthsOfFieldsApart) {
  Domain d(MPI_COMM_WORLD, {12, 5, 7}, {}, support::faces(5));
  Field narrow = labelled(d.grid, 1, 0), wide = labelled(d.grid, 3, 1);
  d.halo.fill({&narrow, &wide}, {0, 5});
  expect_filled(narrow, d.grid, 0, {0, 5});
  expect_filled(wide, d.grid, 1, {0, 5});
}

}  // namespace
}  // namespace softwall::grid
