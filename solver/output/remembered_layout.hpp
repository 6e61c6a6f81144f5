#pragma once

#include <optional>

#include "solver/case/case.hpp"
#include "solver/parallel/decomposition.hpp"
#include "solver/run_directory/run_files.hpp"

/// How a case is shared among its ranks. Sums over ranks depend in their last bits on who holds what, so the
/// answer must not change when a case is resumed: what was measured once is remembered in layout.json, a
/// small file of the run directory, for every number of ranks.
namespace softwall::output {

/// Up to here slabs in z are taken without measuring: they need two transposes instead of six, and two
/// campaigns that do the same then have the same bits.
constexpr int kFewRanks = 16;

/// The layout for the ranks of `world`: remembered, or measured now and remembered; empty (the first possible
/// one) on `few` ranks and where there is no choice. A file that cannot be used is replaced. Collective.
/// Throws AgreedError when the file cannot be written.
[[nodiscard]] std::optional<parallel::Layout> remembered_layout(const RunFiles& run, const Physics& physics,
                                                                const parallel::Communicator& world,
                                                                int few = kFewRanks);

}  // namespace softwall::output
