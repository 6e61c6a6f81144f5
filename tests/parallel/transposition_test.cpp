#include "solver/parallel/transposition.hpp"

#include <gtest/gtest.h>

#include <complex>

// Every value finds its place and its way back, for sizes that do not divide, on any number of ranks.
namespace softwall::parallel {
namespace {

using Value = std::complex<double>;
constexpr int kPadding = 3;  // rows need not be packed tightly

Value label(int z, int y, int mode, int round) { return {1.0 + mode + 100.0 * z, y + 0.25 * round}; }

struct Sizes {
  int modes, rows, z;
};

/// Calls `work(block, its rows)` for every block of two rows at most.
template <class Work>
void for_each_block(const Sizes& n, Range own_z, const Work& work) {
  constexpr int kPlanes = Transposition<Value>::kPlanes;
  const std::ptrdiff_t stride = n.modes + kPadding;
  for (int k = 0; k < own_z.size(); k += kPlanes) {
    for (int j = 0; j < n.rows; j += 2) {
      const RowBlock b{k, std::min(k + kPlanes, own_z.size()), j, std::min(j + 2, n.rows)};
      std::vector<Value> rows(static_cast<std::size_t>(b.planes() * b.rows() * stride));
      work(b, rows, stride);
    }
  }
}

/// Calls `visit(value, z, y, mode)` for every value of a block.
template <class Visit>
void for_each_value(const RowBlock& b, std::vector<Value>& rows, std::ptrdiff_t stride, const Sizes& n,
                    Range own_z, const Visit& visit) {
  Value* row = rows.data();
  for (int k = b.k0; k < b.k1; ++k) {
    for (int j = b.j0; j < b.j1; ++j, row += stride) {
      for (int mode = 0; mode < n.modes; ++mode) visit(row[mode], own_z.begin + k, j, mode);
    }
  }
}

void there_and_back(Transposition<Value>& turn, const Sizes& n, Range own_z, int round) {
  for_each_block(n, own_z, [&](const RowBlock& b, std::vector<Value>& rows, std::ptrdiff_t stride) {
    for_each_value(b, rows, stride, n, own_z,
                   [=](Value& v, int z, int y, int m) { v = label(z, y, m, round); });
    turn.pack(b, rows.data(), stride);
  });
  turn.to_modes();
  const Range own_modes = turn.own_modes();
  const std::ptrdiff_t stride = n.z + kPadding;
  std::vector<Value> plane(static_cast<std::size_t>(n.rows * stride));
  for (int mode = 0; mode < own_modes.size(); ++mode) {
    turn.load(mode, plane.data(), stride);
    for (int j = 0; j < n.rows; ++j) {
      for (int z = 0; z < n.z; ++z) {
        Value& v = plane[static_cast<std::size_t>(j * stride + z)];
        ASSERT_EQ(v, label(z, j, own_modes.begin + mode, round)) << "z " << z << ", row " << j;
        v *= 2;
      }
    }
    turn.store(mode, plane.data(), stride);
  }
  turn.to_planes();
  for_each_block(n, own_z, [&](const RowBlock& b, std::vector<Value>& rows, std::ptrdiff_t row_stride) {
    turn.unpack(b, rows.data(), row_stride);
    for_each_value(b, rows, row_stride, n, own_z,
                   [=](const Value& v, int z, int y, int m) { ASSERT_EQ(v, 2.0 * label(z, y, m, round)); });
  });
}

TEST(Transposition, BringsEveryValueThereAndBackAgainAndAgain) {
  const auto line = Communicator::duplicate(MPI_COMM_WORLD);
  for (const Sizes& n : {Sizes{9, 5, 16}, {8, 4, 7}, {5, 7, 9}, {17, 1, 6}, {2, 3, 12}, {4, 3, 2}}) {
    for (const Way way : {Way::kBest, Way::kMessages}) {
      SCOPED_TRACE(testing::Message() << n.modes << " modes, " << n.rows << " rows, " << n.z << " planes");
      Transposition<Value> turn(line, n.modes, n.rows, n.z, nullptr, way);
      const Range own_z = share(n.z, line.size(), line.rank());
      for (int round = 0; round < 4; ++round) there_and_back(turn, n, own_z, round);
    }
  }
}

TEST(Transposition, ThereTwiceIsRefused) {
  const auto line = Communicator::duplicate(MPI_COMM_WORLD);
  if (line.size() == 1) GTEST_SKIP() << "one rank has nobody to exchange with";
  Transposition<Value> turn(line, 8, 4, 8);
  turn.to_modes();
  EXPECT_THROW(turn.to_modes(), std::logic_error);
}

}  // namespace
}  // namespace softwall::parallel
