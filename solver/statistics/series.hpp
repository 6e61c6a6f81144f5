#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "solver/statistics/blocks.hpp"
#include "solver/statistics/profiles.hpp"

/// The numbers that a whole plane or box has at one moment.
namespace softwall::statistics {

struct SeriesKind {
  std::string_view name;
  Combine combine;
  /// Empty where solver/run_directory/quantities.hpp knows the name.
  std::string_view unit, description;
};

/// The series of a flow, in the order of series_sample(). (The driving gradient is not among them: it is
/// integrated over every step and not sampled.)
[[nodiscard]] std::span<const SeriesKind> series_kinds(bool elastic);

/// Their values now, the same on all ranks. `means` are those of the same state. Collective.
[[nodiscard]] std::vector<double> series_sample(const time::State& state, const time::Setup& setup,
                                                const PlaneMeans& means);

}  // namespace softwall::statistics
