#pragma once

#include <span>
#include <vector>

#include "solver/statistics/series.hpp"

/// What a closed box has instead of a channel's profiles and series: its energy and the path and figure of
/// its solid.
namespace softwall::statistics {

/// In the order of box_series_sample(); all but the first exist with a solid only.
[[nodiscard]] std::span<const SeriesKind> box_series_kinds(bool elastic);

/// Their values now, the same on all ranks. Collective.
[[nodiscard]] std::vector<double> box_series_sample(const time::State& state, const time::Setup& setup);

}  // namespace softwall::statistics
