#pragma once

#include <string>

#include "solver/run_directory/block_statistics.hpp"

/// The vocabulary of statistics.h5: what each known profile and series is called, its unit and its meaning.
/// Solver, reader and plots agree on these names and on nothing else.
namespace softwall::analysis {

/// Meaning of a known name; nullptr when the name is not known here.
[[nodiscard]] const Meaning* known_meaning(const std::string& name);

/// Meaning of a name in these statistics: their own first, then the known ones; nullptr when neither has it.
[[nodiscard]] const Meaning* meaning_of(const BlockStatistics& statistics, const std::string& name);

}  // namespace softwall::analysis
