#include "solver/parallel/transfer.hpp"

#include <gtest/gtest.h>

#include "tests/support/domain.hpp"

// Properties over samples: every pair of axes, sizes that do not divide, on any number of ranks.
namespace softwall::parallel {
namespace {

/// A different number for every global cell.
template <class T>
T label(int z, int y, int x) {
  return T(1 + x + 100 * y + 10000 * z);
}
template <>
std::complex<double> label(int z, int y, int x) {
  return {1.0 + x, y + 100.0 * z};
}

/// The part of the labelled array that starts at `begin`.
template <class T>
std::vector<T> labelled(const Extents& extents, const Extents& begin) {
  std::vector<T> cells;
  for (int z = 0; z < extents[kZ]; ++z) {
    for (int y = 0; y < extents[kY]; ++y) {
      for (int x = 0; x < extents[kX]; ++x)
        cells.push_back(label<T>(begin[kZ] + z, begin[kY] + y, begin[kX] + x));
    }
  }
  return cells;
}

template <class T>
void round_trip(const Communicator& line, Axis scattered, Axis gathered, const Extents& whole, Way way) {
  const Range split = share(whole[gathered], line.size(), line.rank());
  Extents before = whole, before_begin{0, 0, 0}, after_begin{0, 0, 0};
  before[gathered] = split.size();
  before_begin[gathered] = split.begin;
  Transfer<T> transfer(line, before, scattered, gathered, whole[gathered], nullptr, way);
  after_begin[scattered] = share(whole[scattered], line.size(), line.rank()).begin;
  ASSERT_EQ(transfer.trivial(), line.size() == 1);
  ASSERT_EQ(transfer.after()[gathered], whole[gathered]);

  const auto source = labelled<T>(before, before_begin);
  const auto expected = labelled<T>(transfer.after(), after_begin);
  std::vector<T> target(expected.size(), T(-1)), back(source.size(), T(-1));
  transfer.forward(source.data(), target.data());
  EXPECT_EQ(target, expected);
  transfer.backward(target.data(), back.data());
  EXPECT_EQ(back, source);
}

template <class T>
void all_axes_and_sizes() {
  const auto line = Communicator::duplicate(MPI_COMM_WORLD);
  if (line.size() == 1) GTEST_SKIP() << "on one rank both layouts are the same and nothing is called";
  const std::vector<Extents> sizes{{7, 8, 9}, {9, 7, 8}, {8, 9, 7}, {3, 2, 5}};  // the last: fewer than ranks
  for (const Axis scattered : {kZ, kY, kX}) {
    for (const Axis gathered : {kZ, kY, kX}) {
      if (scattered == gathered) continue;
      for (const Extents& whole : sizes) {
        for (const Way way : {Way::kBest, Way::kMessages})
          round_trip<T>(line, scattered, gathered, whole, way);
      }
    }
  }
}

TEST(Transfer, RoundTripOfRealNumbers) { all_axes_and_sizes<double>(); }
TEST(Transfer, RoundTripOfComplexNumbers) { all_axes_and_sizes<std::complex<double>>(); }
TEST(Transfer, RoundTripInSinglePrecision) { all_axes_and_sizes<float>(); }

}  // namespace
}  // namespace softwall::parallel
