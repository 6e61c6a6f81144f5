#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "solver/parallel/mpi.hpp"
#include "solver/parallel/profile.hpp"

namespace softwall::output {

/// A profile of all ranks together: times are means over the ranks, messages and bytes sums. Collective.
[[nodiscard]] std::array<parallel::PhaseRecord, parallel::kPhases> gather_profile(
    parallel::Profile& profile, const parallel::Communicator& world);

/// One line a phase: nanoseconds per cell and step, share of the time, messages and megabytes a step and
/// rank.
[[nodiscard]] std::string profile_table(const std::array<parallel::PhaseRecord, parallel::kPhases>& records,
                                        std::int64_t steps, double cells, int ranks);

}  // namespace softwall::output
