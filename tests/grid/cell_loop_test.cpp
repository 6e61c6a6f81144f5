#include "solver/grid/cell_loop.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace softwall::grid {
namespace {

TEST(CellLoop, VisitsEveryCellOfTheBoxOnce) {
  std::vector<int> visits(10 * 10 * 10);
  int* const count = visits.data();
  for_each_cell({2, 9, 1, 4, 3, 5}, [=](int i, int j, int k) { ++count[i + 10 * j + 100 * k]; });
  for (int k = 0; k < 10; ++k) {
    for (int j = 0; j < 10; ++j) {
      for (int i = 0; i < 10; ++i) {
        const bool inside = i >= 2 && i < 9 && j >= 1 && j < 4 && k >= 3 && k < 5;
        ASSERT_EQ(count[i + 10 * j + 100 * k], inside ? 1 : 0);
      }
    }
  }
}

TEST(CellLoop, SumsAndFindsTheLargest) {
  const Box box{0, 13, 0, 3, 0, 2};
  EXPECT_DOUBLE_EQ(sum_cells(box, [](int i, int j, int k) { return i + 100.0 * j + 1000.0 * k; }),
                   6.0 * 78 + 26 * 300.0 + 39 * 1000.0);
  EXPECT_DOUBLE_EQ(
      max_cells(box, 0, [](int i, int j, int k) { return i == 5 && j == 2 && k == 1 ? 4.0 : -1; }), 4);
  EXPECT_DOUBLE_EQ(max_cells(box, -7, [](int, int, int) { return -9.0; }), -7);
}

TEST(CellLoop, AnEmptyBoxGivesNothing) {
  const Box empty{0, 5, 3, 3, 0, 5};
  EXPECT_EQ(sum_cells(empty, [](int, int, int) { return 1.0; }), 0.0);
  EXPECT_EQ(max_cells(empty, 2.5, [](int, int, int) { return 9.0; }), 2.5);
}

TEST(CellLoop, BoxesFollowTheGrid) {
  Grid g;
  g.nx = 4;
  g.ny = 5;
  g.nz = 6;
  EXPECT_EQ(sum_cells(all_cells(g), [](int, int, int) { return 1.0; }), 120.0);
  EXPECT_EQ(sum_cells(rows(g, 1, 3), [](int, int, int) { return 1.0; }), 48.0);
}

}  // namespace
}  // namespace softwall::grid
