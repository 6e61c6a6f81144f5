#include "solver/statistics/statistics.hpp"

#include <algorithm>
#include <string>

#include "solver/case/time_comparison.hpp"
#include "solver/statistics/closed_box/box_series.hpp"
#include "solver/statistics/profiles.hpp"
#include "solver/statistics/series.hpp"
#include "solver/statistics/wave_series.hpp"

namespace softwall::statistics {

namespace {

bool elastic(const time::Setup& setup) { return setup.solid.has_value(); }

/// Only a driven channel has plane means: no direction in a closed box is statistically uniform, and the mean
/// of a wave is zero.
bool has_profiles(const time::Setup& setup) { return is_driven_channel(setup.physics.flow); }

std::span<const SeriesKind> series_of(const time::Setup& setup) {
  if (has_profiles(setup)) return series_kinds(elastic(setup));
  return is_closed_box(setup.physics.flow) ? box_series_kinds(elastic(setup)) : wave_series_kinds();
}

Blocks empty_blocks(const time::Setup& setup) {
  std::vector<Combine> combines;
  for (const auto& kind : series_of(setup)) combines.push_back(kind.combine);
  const PlaneMeans means(elastic(setup), setup.grid.ny);
  const auto& spec = setup.physics.statistics;
  return {{spec.start_time, spec.block_length},
          has_profiles(setup) ? means.values().size() : 0,
          std::move(combines)};
}

analysis::BlockStatistics frame(const time::Setup& setup) {
  const auto& g = setup.grid;
  analysis::BlockStatistics frame;
  frame.reynolds = setup.physics.reynolds;
  frame.elastic = elastic(setup);
  frame.interface_y = g.y_face[g.ny_fluid];
  for (int j = 0; j < g.ny; ++j) frame.y_center.push_back(g.y_center[j]);
  for (int j = 0; j <= g.ny; ++j) frame.y_face.push_back(g.y_face[j]);
  return frame;
}

template <class Kind>
void explain(const Kind& kind, analysis::BlockStatistics& statistics) {
  if (kind.description.empty()) return;
  statistics.meanings[std::string(kind.name)] = {std::string(kind.unit), std::string(kind.description)};
}

void append_profiles(const Block& block, analysis::BlockStatistics& to) {
  const std::size_t rows = to.y_face.size();
  std::size_t first = 0;
  for (const auto& kind : profile_kinds(to.elastic)) {
    auto& profile = to.profiles[std::string(kind.name)];
    profile.location = kind.location;
    for (std::size_t j = 0; j < to.points(kind.location); ++j) {
      profile.values.push_back(block.profiles[first + j] / block.sampled);
    }
    first += rows;
    explain(kind, to);
  }
}

void append_series(const Blocks& blocks, const Block& block, std::span<const SeriesKind> kinds,
                   analysis::BlockStatistics& to) {
  std::size_t s = 0;
  for (const auto& kind : kinds) {
    to.series[std::string(kind.name)].push_back(blocks.series_value(block, s++));
    explain(kind, to);
  }
}

}  // namespace

Statistics::Statistics(const time::Setup& setup) : setup_(setup), blocks_(empty_blocks(setup)) {}

void Statistics::sample_step(const time::State& s, double dt) {
  const auto& spec = setup_.physics.statistics;
  const double duration = clock_.counted(s.time, dt, spec.start_time);
  if (duration == 0) return;
  blocks_.add_step(s.time, duration, s.driving_gradient);
  if (s.step % spec.interval_steps == 0) sample_fields(s, clock_.take(s.time));
}

void Statistics::sample_fields(const time::State& s, double weight) {
  if (!has_profiles(setup_)) {
    const bool box = is_closed_box(setup_.physics.flow);
    blocks_.add_sample(s.time, weight, {},
                       box ? box_series_sample(s, setup_) : wave_series_sample(s, setup_));
    return;
  }
  const PlaneMeans means = plane_means(s, setup_);
  blocks_.add_sample(s.time, weight, means.values(), series_sample(s, setup_, means));
}

std::vector<double> Statistics::pack() const {
  std::vector<double> packed = blocks_.pack();
  const auto of_clock = clock_.pack();
  packed.insert(packed.end(), of_clock.begin(), of_clock.end());
  return packed;
}

void Statistics::unpack(std::span<const double> packed) {
  const std::size_t of_blocks = packed.size() - std::min(packed.size(), clock_.pack().size());
  blocks_.unpack(packed.first(of_blocks));
  clock_.unpack(packed.subspan(of_blocks));
}

analysis::BlockStatistics Statistics::blocks() const {
  auto result = frame(setup_);
  const auto& schedule = blocks_.schedule();
  for (const Block& block : blocks_.all()) {
    if (!(block.sampled > 0)) continue;  // steps, but no sample yet
    result.start.push_back(schedule.start + double(block.index) * schedule.length);
    result.end.push_back(schedule.start + double(block.index + 1) * schedule.length);
    result.weight.push_back(block.sampled);
    append_series(blocks_, block, series_of(setup_), result);
    if (!has_profiles(setup_)) continue;
    append_profiles(block, result);
    result.series["driving_gradient"].push_back(block.driven / block.stepped);
  }
  // The last block may still be open: nothing after its last sample has been seen.
  const double last = clock_.last_sample();
  if (!result.end.empty() && !has_reached(last, result.end.back())) result.end.back() = last;
  return result;
}

}  // namespace softwall::statistics
