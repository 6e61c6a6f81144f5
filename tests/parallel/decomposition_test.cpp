#include <gtest/gtest.h>

#include <vector>

#include "tests/support/domain.hpp"

namespace softwall::parallel {
namespace {

using support::fits;
using support::world_size;

/// How many ranks hold each column (x fastest).
std::vector<int> owners(const Decomposition& d, int nx, int nz) {
  std::vector<int> count(static_cast<std::size_t>(nx * nz));
  for (int z = d.z().begin; z < d.z().end; ++z) {
    for (int x = d.x().begin; x < d.x().end; ++x) ++count[static_cast<std::size_t>(z * nx + x)];
  }
  MPI_Allreduce(MPI_IN_PLACE, count.data(), nx * nz, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  return count;
}

TEST(Decomposition, GivesEveryColumnToOneRankOrRefuses) {
  for (int nx = 1; nx <= 13; ++nx) {
    for (int nz = 1; nz <= 13; ++nz) {
      if (!fits(nx, nz, world_size())) {
        EXPECT_THROW(Decomposition(MPI_COMM_WORLD, nx, nz), std::invalid_argument) << nx << " x " << nz;
        continue;
      }
      const Decomposition d(MPI_COMM_WORLD, nx, nz);
      EXPECT_EQ(d.px() * d.pz(), world_size());
      EXPECT_GE(d.x().size(), d.px() > 1 ? Decomposition::kMinimumWidth : 1);
      EXPECT_GE(d.z().size(), d.pz() > 1 ? Decomposition::kMinimumWidth : 1);
      for (const int n : owners(d, nx, nz)) ASSERT_EQ(n, 1) << nx << " x " << nz;
    }
  }
}

TEST(Decomposition, PrefersSlabsInZ) {
  const Decomposition d(MPI_COMM_WORLD, 64, 64);
  EXPECT_EQ(d.px(), 1);
  EXPECT_EQ(d.pz(), world_size());
}

TEST(Decomposition, SplitsBothDirectionsWhenZIsShort) {
  if (world_size() != 4 && world_size() != 6) GTEST_SKIP() << "needs 4 or 6 ranks";
  const Decomposition d(MPI_COMM_WORLD, 12, 6);
  EXPECT_EQ(d.pz(), 2);
  EXPECT_EQ(d.px(), world_size() / 2);
}

TEST(Decomposition, TakesAnyPossibleLayoutAndNoOther) {
  for (const Layout& layout : possible_layouts(world_size(), 24, 24)) {
    const Decomposition d(MPI_COMM_WORLD, 24, 24, layout);
    EXPECT_EQ(d.px(), layout.px);
    EXPECT_EQ(d.pz(), layout.pz);
    for (const int n : owners(d, 24, 24)) ASSERT_EQ(n, 1);
  }
  EXPECT_THROW(Decomposition(MPI_COMM_WORLD, 24, 24, Layout{world_size() + 1, 1}), std::invalid_argument);
}

TEST(PossibleLayouts, HaveWideParts) {
  EXPECT_EQ(possible_layouts(1, 3, 3), (std::vector<Layout>{{1, 1}}));
  EXPECT_EQ(possible_layouts(12, 12, 9), (std::vector<Layout>{{4, 3}}));
  EXPECT_EQ(possible_layouts(4, 12, 12), (std::vector<Layout>{{1, 4}, {2, 2}, {4, 1}}));
  EXPECT_TRUE(possible_layouts(7, 12, 12).empty());
}

TEST(Decomposition, LinesJoinTheRanksThatDifferInOneDirection) {
  const int nx = 12, nz = world_size() == 1 ? 3 : 6;  // with 4 and 6 ranks both directions are split
  const Decomposition d(MPI_COMM_WORLD, nx, nz);
  ASSERT_EQ(d.x_line().size(), d.px());
  ASSERT_EQ(d.z_line().size(), d.pz());
  const Range x = share(nx, d.px(), d.x_line().rank()), z = share(nz, d.pz(), d.z_line().rank());
  EXPECT_EQ(d.x().begin, x.begin);  // rank order along a line is the order of columns
  EXPECT_EQ(d.x().end, x.end);
  EXPECT_EQ(d.z().begin, z.begin);
  EXPECT_EQ(d.z().end, z.end);
  std::vector<int> z_begins(static_cast<std::size_t>(d.px()));
  const int mine = d.z().begin;
  MPI_Allgather(&mine, 1, MPI_INT, z_begins.data(), 1, MPI_INT, d.x_line().get());
  for (const int other : z_begins) EXPECT_EQ(other, mine);
}

TEST(Decomposition, RefusesANarrowGridAndSaysWhy) {
  if (world_size() == 1) GTEST_SKIP() << "one rank holds any grid";
  try {
    const Decomposition d(MPI_COMM_WORLD, 2, 5);
    FAIL() << "a grid two columns wide was accepted";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("2 x 5"), std::string::npos) << text;
    EXPECT_NE(text.find(std::to_string(world_size()) + " ranks"), std::string::npos) << text;
  }
}

TEST(Communicator, MovesItsHandle) {
  Communicator first = Communicator::duplicate(MPI_COMM_WORLD);
  const MPI_Comm handle = first.get();
  Communicator second = std::move(first);
  EXPECT_EQ(second.get(), handle);
  Communicator third;
  third = std::move(second);
  EXPECT_EQ(third.get(), handle);
  EXPECT_EQ(third.size(), world_size());
}

}  // namespace
}  // namespace softwall::parallel
