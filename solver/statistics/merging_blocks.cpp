#include "solver/statistics/merging_blocks.hpp"

#include <stdexcept>
#include <utility>

#include "solver/statistics/packed_reader.hpp"

namespace softwall::statistics {

void MergingBlocks::add_sample(double time, double weight, std::span<const double> values) {
  const auto is_new = [&] { return blocks_.empty() || blocks_.back().index != schedule().block_at(time); };
  while (is_new() && blocks_.size() == kMost) merge();
  if (is_new()) blocks_.push_back({schedule().block_at(time), 0, std::vector<double>(values_)});
  Block& block = blocks_.back();
  block.sampled += weight;
  for (std::size_t n = 0; n < values_; ++n) block.sums[n] += weight * values[n];
}

void MergingBlocks::merge() {
  merged_ *= 2;
  std::vector<Block> longer;
  for (Block& block : blocks_) {
    block.index /= 2;
    if (longer.empty() || longer.back().index != block.index) {
      longer.push_back(std::move(block));
      continue;
    }
    longer.back().sampled += block.sampled;
    for (std::size_t n = 0; n < values_; ++n) longer.back().sums[n] += block.sums[n];
  }
  blocks_ = std::move(longer);
}

std::vector<double> MergingBlocks::pack(const Exchange& to_whole) const {
  std::vector<double> packed{shortest_.start, shortest_.length, merged_, double(blocks_.size())};
  for (const Block& block : blocks_) {
    packed.insert(packed.end(), {double(block.index), block.sampled});
    const auto whole = to_whole(block.sums);
    packed.insert(packed.end(), whole.begin(), whole.end());
  }
  return packed;
}

void MergingBlocks::unpack(std::span<const double> packed, std::size_t whole_values,
                           const Exchange& to_part) {
  PackedReader reader(packed);
  const double start = reader.number(), length = reader.number(), merged = reader.number();
  if (start != shortest_.start || length != shortest_.length)
    throw std::runtime_error("statistics of a checkpoint belong to another schedule of blocks");
  std::vector<Block> blocks;
  for (double left = reader.number(); left > 0; --left) {
    Block& block = blocks.emplace_back();
    block.index = static_cast<std::int64_t>(reader.number());
    block.sampled = reader.number();
    block.sums = to_part(reader.numbers(whole_values));
  }
  reader.must_be_at_the_end();
  merged_ = merged;
  blocks_ = std::move(blocks);
}

}  // namespace softwall::statistics
