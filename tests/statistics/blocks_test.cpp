#include "solver/statistics/blocks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace softwall::statistics {
namespace {

const std::vector<Combine> kCombines = {Combine::kMean, Combine::kMinimum, Combine::kMaximum};

TEST(BlockSchedule, AStepThatEndsOnABoundaryBelongsToTheBlockBeforeIt) {
  const BlockSchedule schedule{.start = 10, .length = 0.5};
  EXPECT_EQ(schedule.block_at(10.0001), 0);
  EXPECT_EQ(schedule.block_at(10.5), 0);
  EXPECT_EQ(schedule.block_at(10.500001), 1);
  EXPECT_EQ(schedule.block_at(11), 1);
  EXPECT_EQ(schedule.block_at(110.25), 200);
}

TEST(BlockSchedule, StepsOfFixedLengthFillBlocksEvenlyInSpiteOfRoundOff) {
  for (const double start : {0.0, 0.3, 7.0}) {
    const BlockSchedule schedule{.start = start, .length = 1};
    std::array<int, 50> steps{};
    double time = start;
    for (int n = 0; n < 5000; ++n) {
      time += 0.01;
      ++steps.at(static_cast<std::size_t>(schedule.block_at(time)));
    }
    for (const int count : steps) EXPECT_EQ(count, 100);
  }
}

TEST(Blocks, MeansAreWeightedByTimeAndExtremesAreNot) {
  Blocks blocks({0, 1}, 2, kCombines);
  blocks.add_sample(0.5, 0.5, std::array{1.0, 10.0}, std::array{3.0, 3.0, 3.0});
  blocks.add_sample(0.75, 0.25, std::array{4.0, -2.0}, std::array{6.0, 6.0, 6.0});
  ASSERT_EQ(blocks.all().size(), 1u);
  const Block& block = blocks.all()[0];
  EXPECT_EQ(block.sampled, 0.75);
  EXPECT_EQ(block.profiles, (std::vector{1.5, 4.5}));
  EXPECT_EQ(blocks.series_value(block, 0), 4.0);
  EXPECT_EQ(blocks.series_value(block, 1), 3.0);
  EXPECT_EQ(blocks.series_value(block, 2), 6.0);
}

TEST(Blocks, ExtremesOfNegativeNumbersAreRight) {
  Blocks blocks({0, 1}, 0, kCombines);
  blocks.add_sample(0.5, 0.5, {}, std::array{-3.0, -3.0, -3.0});
  blocks.add_sample(0.6, 0.1, {}, std::array{-5.0, -5.0, -5.0});
  EXPECT_EQ(blocks.series_value(blocks.all()[0], 1), -5.0);
  EXPECT_EQ(blocks.series_value(blocks.all()[0], 2), -3.0);
}

TEST(Blocks, ALongStepMaySkipBlocks) {
  Blocks blocks({0, 1}, 0, {});
  blocks.add_step(0.5, 0.5, 2.0);
  blocks.add_step(1.0, 0.5, 4.0);
  blocks.add_step(7.5, 6.5, 1.0);
  ASSERT_EQ(blocks.all().size(), 2u);
  EXPECT_EQ(blocks.all()[0].driven, 3.0);
  EXPECT_EQ(blocks.all()[0].stepped, 1.0);
  EXPECT_EQ(blocks.all()[1].index, 7);
}

Blocks filled() {
  Blocks blocks({0.1, 0.3}, 2, kCombines);
  for (int n = 1; n < 20; ++n) {
    const double time = 0.1 + n * 0.07, x = std::sqrt(2.0 + n) / 3;
    blocks.add_step(time, 0.07, x);
    if (n % 3 == 0) blocks.add_sample(time, 0.21, std::array{x, 1 / x}, std::array{x, -x, x * x});
  }
  return blocks;
}

TEST(Blocks, PackingKeepsEveryBit) {
  const Blocks original = filled();
  Blocks copy({0.1, 0.3}, 2, kCombines);
  copy.unpack(original.pack());
  EXPECT_EQ(copy.pack(), original.pack());
  EXPECT_EQ(copy.all().size(), original.all().size());
}

TEST(Blocks, PackedBlocksOfAnotherShapeOrLengthAreRefusedAndNothingChanges) {
  const auto packed = filled().pack();
  Blocks target = filled();
  target.add_step(9, 0.07, 5);
  const auto before = target.pack();
  for (std::size_t n = 0; n < packed.size(); ++n) {
    EXPECT_THROW(target.unpack(std::span(packed).first(n)), std::runtime_error) << n;
  }
  auto longer = packed;
  longer.push_back(1);
  EXPECT_THROW(target.unpack(longer), std::runtime_error);
  for (const double count : {-1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    auto wrong = packed;
    wrong[4] = count;
    EXPECT_THROW(target.unpack(wrong), std::runtime_error) << count;
  }
  EXPECT_EQ(target.pack(), before);
  EXPECT_THROW(Blocks({0.1, 0.3}, 3, kCombines).unpack(packed), std::runtime_error);
  EXPECT_THROW(Blocks({0.1, 0.4}, 2, kCombines).unpack(packed), std::runtime_error);
  EXPECT_THROW(Blocks({0.1, 0.3}, 2, {Combine::kMean}).unpack(packed), std::runtime_error);
}

}  // namespace
}  // namespace softwall::statistics
