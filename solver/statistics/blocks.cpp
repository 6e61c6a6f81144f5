#include "solver/statistics/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "solver/statistics/packed_reader.hpp"

namespace softwall::statistics {

namespace {

double first_value(Combine combine) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  switch (combine) {
    case Combine::kMinimum:
      return kInfinity;
    case Combine::kMaximum:
      return -kInfinity;
    case Combine::kMean:
      break;
  }
  return 0;
}

}  // namespace

std::int64_t BlockSchedule::block_at(double time) const {
  constexpr double kRoundOff = 1e-6;
  const double blocks = (time - start) / length;
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(blocks - kRoundOff)) - 1);
}

Blocks::Blocks(BlockSchedule schedule, std::size_t profile_values, std::vector<Combine> series)
    : schedule_(schedule), profile_values_(profile_values), series_(std::move(series)) {}

Block& Blocks::block_at(double time) {
  const auto index = schedule_.block_at(time);
  if (blocks_.empty() || blocks_.back().index != index) {
    Block fresh;
    fresh.index = index;
    fresh.profiles.assign(profile_values_, 0.0);
    for (const Combine combine : series_) fresh.series.push_back(first_value(combine));
    blocks_.push_back(std::move(fresh));
  }
  return blocks_.back();
}

void Blocks::add_step(double time, double duration, double gradient) {
  Block& block = block_at(time);
  block.stepped += duration;
  block.driven += duration * gradient;
}

void Blocks::add_sample(double time, double weight, std::span<const double> profiles,
                        std::span<const double> series) {
  Block& block = block_at(time);
  block.sampled += weight;
  for (std::size_t n = 0; n < profile_values_; ++n) block.profiles[n] += weight * profiles[n];
  for (std::size_t s = 0; s < series_.size(); ++s) {
    double& value = block.series[s];
    switch (series_[s]) {
      case Combine::kMean:
        value += weight * series[s];
        break;
      case Combine::kMinimum:
        value = std::min(value, series[s]);
        break;
      case Combine::kMaximum:
        value = std::max(value, series[s]);
        break;
    }
  }
}

double Blocks::series_value(const Block& block, std::size_t s) const {
  return series_[s] == Combine::kMean ? block.series[s] / block.sampled : block.series[s];
}

std::vector<double> Blocks::shape() const {
  return {schedule_.start, schedule_.length, double(profile_values_), double(series_.size())};
}

std::vector<double> Blocks::pack() const {
  std::vector<double> packed = shape();
  packed.push_back(double(blocks_.size()));
  for (const Block& b : blocks_) {
    packed.insert(packed.end(), {double(b.index), b.stepped, b.driven, b.sampled});
    packed.insert(packed.end(), b.profiles.begin(), b.profiles.end());
    packed.insert(packed.end(), b.series.begin(), b.series.end());
  }
  return packed;
}

void Blocks::unpack(std::span<const double> packed) {
  PackedReader reader(packed);
  const auto expected = shape();
  const auto given = reader.numbers(expected.size());
  if (!std::equal(expected.begin(), expected.end(), given.begin())) {
    throw std::runtime_error("statistics of a checkpoint belong to another grid, flow or schedule of blocks");
  }
  const double count = reader.number();
  std::vector<Block> blocks;
  for (double n = 0; n < count; ++n) {
    Block b;
    b.index = static_cast<std::int64_t>(reader.number());
    b.stepped = reader.number();
    b.driven = reader.number();
    b.sampled = reader.number();
    const auto profiles = reader.numbers(profile_values_), series = reader.numbers(series_.size());
    b.profiles.assign(profiles.begin(), profiles.end());
    b.series.assign(series.begin(), series.end());
    blocks.push_back(std::move(b));
  }
  reader.must_be_at_the_end();
  blocks_ = std::move(blocks);
}

}  // namespace softwall::statistics
