#pragma once

#include <span>
#include <vector>

#include "solver/statistics/series.hpp"

/// What an interface wave has instead of a channel's profiles and series: its amplitude over time.
namespace softwall::statistics {

/// In the order of wave_series_sample().
[[nodiscard]] std::span<const SeriesKind> wave_series_kinds();

/// Their values now, the same on all ranks. Collective.
[[nodiscard]] std::vector<double> wave_series_sample(const time::State& state, const time::Setup& setup);

}  // namespace softwall::statistics
