#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// Bookkeeping of time: which block a step belongs to, and the sums of every block.
namespace softwall::statistics {

/// How the samples of a number become its value for a block.
enum class Combine { kMean, kMinimum, kMaximum };

/// When blocks begin and end, h / U_b: block b covers start + b length < t <= start + (b + 1) length.
struct BlockSchedule {
  double start = 0, length = 1;

  /// The block of a step that ends at `time` > start. Steps of fixed length add up to a block's end only to
  /// round-off: a step that ends within a millionth of a block after it still belongs to that block.
  [[nodiscard]] std::int64_t block_at(double time) const;
};

/// Sums over one block.
struct Block {
  std::int64_t index = 0;
  double stepped = 0;            ///< time covered by steps
  double driven = 0;             ///< integral of the driving gradient over that time
  double sampled = 0;            ///< time covered by samples
  std::vector<double> profiles;  ///< sum of weight times value
  std::vector<double> series;    ///< the same, or extreme value so far, as Combine says
};

/// All blocks of a run, in order of time. Depends on no grid and no communicator.
class Blocks {
 public:
  /// `profile_values`: numbers in a sample's profiles; `series`: one entry for each number of its series.
  Blocks(BlockSchedule schedule, std::size_t profile_values, std::vector<Combine> series);

  /// A step that ends at `time`, `duration` of which counts, with mean driving gradient `gradient`.
  void add_step(double time, double duration, double gradient);
  /// A sample taken at `time` that stands for `weight` of time before it.
  void add_sample(double time, double weight, std::span<const double> profiles,
                  std::span<const double> series);

  [[nodiscard]] const BlockSchedule& schedule() const { return schedule_; }
  [[nodiscard]] const std::vector<Block>& all() const { return blocks_; }
  /// Value of series `s` for a block with samples.
  [[nodiscard]] double series_value(const Block& block, std::size_t s) const;

  /// Everything as numbers, and back, exactly. unpack throws std::runtime_error when `packed` is not from
  /// blocks of the same shape and schedule, and then changes nothing.
  [[nodiscard]] std::vector<double> pack() const;
  void unpack(std::span<const double> packed);

 private:
  [[nodiscard]] Block& block_at(double time);
  [[nodiscard]] std::vector<double> shape() const;

  BlockSchedule schedule_;
  std::size_t profile_values_;
  std::vector<Combine> series_;
  std::vector<Block> blocks_;
};

}  // namespace softwall::statistics
