#include "solver/statistics/merging_blocks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace softwall::statistics {
namespace {

std::vector<double> copy(std::span<const double> values) { return {values.begin(), values.end()}; }

/// Two samples in each unit of time up to `end`, of values 1 and the time.
MergingBlocks sampled(int end) {
  MergingBlocks blocks({.start = 2, .length = 1}, 2);
  for (int n = 1; n <= 2 * end; ++n) blocks.add_sample(2 + 0.5 * n, 0.5, std::array{1.0, 2 + 0.5 * n});
  return blocks;
}

TEST(MergingBlocks, AreNeverMoreThanAFewAndLoseNothing) {
  for (const int end : {1, 31, 32, 33, 64, 65, 200, 1000}) {
    const MergingBlocks blocks = sampled(end);
    EXPECT_LE(blocks.all().size(), MergingBlocks::kMost);
    EXPECT_GE(2 * blocks.all().size(),
              std::min<std::size_t>(MergingBlocks::kMost, static_cast<std::size_t>(end)));
    double weight = 0, sum = 0;
    for (const auto& block : blocks.all()) {
      const double length = blocks.schedule().length, block_start = 2 + double(block.index) * length;
      EXPECT_EQ(block.sums[0], block.sampled);
      EXPECT_TRUE(block.sampled == length || &block == &blocks.all().back());
      // Times in it lie evenly between start and end, on average a quarter after the middle.
      EXPECT_DOUBLE_EQ(block.sums[1] / block.sampled, block_start + block.sampled / 2 + 0.25);
      weight += block.sampled;
      sum += block.sums[1];
    }
    EXPECT_EQ(weight, end);
    EXPECT_DOUBLE_EQ(sum / weight, 2 + end / 2.0 + 0.25);
  }
}

TEST(MergingBlocks, ContinueExactlyFromWhatWasPackedAtAnyMoment) {
  const auto whole = sampled(40).pack(copy);
  for (int stop = 0; stop < 40; ++stop) {
    MergingBlocks resumed({.start = 2, .length = 1}, 2);
    resumed.unpack(sampled(stop).pack(copy), 2, copy);
    for (int n = 2 * stop + 1; n <= 80; ++n)
      resumed.add_sample(2 + 0.5 * n, 0.5, std::array{1.0, 2 + 0.5 * n});
    EXPECT_EQ(resumed.pack(copy), whole) << stop;
  }
}

TEST(MergingBlocks, SkipWhatWasNotSampled) {
  MergingBlocks blocks({.start = 0, .length = 1}, 1);
  constexpr int kSamples = static_cast<int>(MergingBlocks::kMost) + 1;  // each in a block of its own at first
  for (int n = 0; n < kSamples; ++n) blocks.add_sample(3 * n + 0.5, 0.25, std::array{double(n)});
  EXPECT_EQ(blocks.schedule().length, 4);
  double weight = 0;
  for (const auto& block : blocks.all()) weight += block.sampled;
  EXPECT_EQ(weight, kSamples * 0.25);
}

TEST(MergingBlocks, OfAnotherShapeAreRefused) {
  MergingBlocks blocks({.start = 2, .length = 1}, 2), later({.start = 3, .length = 1}, 2);
  const auto packed = sampled(3).pack(copy);
  EXPECT_THROW(later.unpack(packed, 2, copy), std::runtime_error);
  EXPECT_THROW(blocks.unpack(packed, 3, copy), std::runtime_error);
  EXPECT_THROW(blocks.unpack(packed, 1, copy), std::runtime_error);
  EXPECT_THROW(blocks.unpack({}, 2, copy), std::runtime_error);
  EXPECT_TRUE(blocks.all().empty());
}

}  // namespace
}  // namespace softwall::statistics
