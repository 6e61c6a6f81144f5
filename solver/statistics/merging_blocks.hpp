#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "solver/statistics/blocks.hpp"

namespace softwall::statistics {

/// Sums over blocks of time, of which there are never more than a few however long a run becomes: for samples
/// of so many numbers that a set for every block of the profiles would fill the disk. When there would be
/// more than kMost, two neighbours at a time become one, and blocks are twice as long from then on.
class MergingBlocks {
 public:
  /// After they have become one there are half as many, of which those of the transient are of no use: enough
  /// are left for intervals (eight).
  static constexpr std::size_t kMost = 32;

  /// `shortest`: the blocks that a run begins with; `values`: numbers of a sample.
  MergingBlocks(BlockSchedule shortest, std::size_t values) : shortest_(shortest), values_(values) {}

  struct Block {
    std::int64_t index = 0;    ///< in schedule()
    double sampled = 0;        ///< time covered by samples, h / U_b
    std::vector<double> sums;  ///< of weight times value
  };

  /// A sample taken at `time` that stands for `weight` of time before it.
  void add_sample(double time, double weight, std::span<const double> values);

  [[nodiscard]] const std::vector<Block>& all() const { return blocks_; }
  [[nodiscard]] std::size_t values() const { return values_; }
  /// The blocks as they are now.
  [[nodiscard]] BlockSchedule schedule() const { return {shortest_.start, shortest_.length * merged_}; }

  /// What a checkpoint holds of a block's sums, from what this rank has of them; and the other way round.
  using Exchange = std::function<std::vector<double>(std::span<const double>)>;

  /// Everything as numbers. Collective where `to_whole` is.
  [[nodiscard]] std::vector<double> pack(const Exchange& to_whole) const;
  /// Back again, exactly; `whole_values`: numbers that the checkpoint holds of a block. Throws
  /// std::runtime_error when `packed` is of another schedule or shape, and then changes nothing.
  void unpack(std::span<const double> packed, std::size_t whole_values, const Exchange& to_part);

 private:
  void merge();

  BlockSchedule shortest_;
  std::size_t values_;
  double merged_ = 1;  ///< of the shortest in a block of today
  std::vector<Block> blocks_;
};

}  // namespace softwall::statistics
