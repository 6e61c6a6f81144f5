#include "solver/grid/field.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <set>

#include "tests/support/domain.hpp"

namespace softwall::grid {
namespace {

Grid small_grid(int nx, int ny, int nz) {
  Grid g;
  g.nx = nx;
  g.ny = ny;
  g.nz = nz;
  return g;
}

class FieldInMemory : public testing::TestWithParam<Memory> {};

INSTANTIATE_TEST_SUITE_P(ByPlane, FieldInMemory, testing::Values(Memory::kByPlane));
INSTANTIATE_TEST_SUITE_P(ByHeight, FieldInMemory, testing::Values(Memory::kByHeight));

TEST_P(FieldInMemory, StartsAtZeroEverywhere) {
  const Field f(small_grid(5, 4, 3), 2, GetParam());
  for (int k = -2; k < 5; ++k) {
    for (int j = -2; j < 6; ++j) {
      for (int i = -2; i < 7; ++i) ASSERT_EQ(f(i, j, k), 0.0);
    }
  }
}

TEST_P(FieldInMemory, EveryCellHasItsOwnPlaceXFastest) {
  for (const int ghost : {0, 1, 3}) {
    Field f(small_grid(5, 4, 3), ghost, GetParam());
    std::set<const Real*> places;
    const auto view = f.view();
    for (int k = -ghost; k < 3 + ghost; ++k) {
      for (int j = -ghost; j < 4 + ghost; ++j) {
        for (int i = -ghost; i < 5 + ghost; ++i) {
          places.insert(&view(i, j, k));
          if (i > -ghost) {
            EXPECT_EQ(&view(i, j, k), &view(i - 1, j, k) + 1);
          }
        }
      }
    }
    const int h = 2 * ghost;
    EXPECT_EQ(places.size(), static_cast<std::size_t>((5 + h) * (4 + h) * (3 + h)));
  }
}

TEST_P(FieldInMemory, RowsBeginLinesOfTheCacheAndDoNotCrowdIt) {
  for (const int nx : {5, 62, 64, 126, 128}) {
    for (const int ghost : {0, 1, 3}) {
      Field f(small_grid(nx, 3, 2), ghost, GetParam());
      for (int k = -ghost; k < 2 + ghost; ++k) {
        for (int j = -ghost; j < 3 + ghost; ++j)
          ASSERT_EQ(reinterpret_cast<std::uintptr_t>(&f.view()(0, j, k)) % 64, 0) << nx << ", " << ghost;
      }
      EXPECT_NE(f.view().stride_y * sizeof(Real) % 512, 0) << nx << ", " << ghost;
    }
  }
}

/// Pages of this process that are in memory, in bytes.
std::size_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::size_t whole = 0, resident = 0;
  statm >> whole >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST(Field, ByHeightCostsTheRowsThatAreTouched) {
  constexpr std::size_t kRow = 126 * 126 * sizeof(Real);
  const std::size_t before = resident_bytes();
  Field f(small_grid(126, 400, 126), 1, Memory::kByHeight);
  for (int j = 350; j < 400; ++j) {
    for (int k = 0; k < 126; ++k) f(0, j, k) = 1;
  }
  EXPECT_LT(resident_bytes() - before, 150 * kRow);
  EXPECT_EQ(f(0, 349, 0), 0);
}

TEST(Field, ViewsSeeWhatTheFieldHolds) {
  Field f(small_grid(5, 4, 3), 1);
  f(-1, 4, 2) = 7;
  EXPECT_EQ(f.view()(-1, 4, 2), 7);
  EXPECT_EQ(std::as_const(f).view()(-1, 4, 2), 7);
  f.view()(0, 0, 0) = 8;
  EXPECT_EQ(f(0, 0, 0), 8);
}

TEST(Field, MovesItsMemory) {
  Field f(small_grid(5, 4, 3), 1);
  f(1, 2, 0) = 9;
  const Real* place = &f.view()(1, 2, 0);
  const Field g = std::move(f);
  EXPECT_EQ(&g.view()(1, 2, 0), place);
  EXPECT_EQ(g(1, 2, 0), 9);
  EXPECT_EQ(g.ghost(), 1);
}

}  // namespace
}  // namespace softwall::grid
