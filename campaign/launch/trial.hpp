#pragma once

#include <filesystem>
#include <string>

namespace softwall::campaign {

/// Starts that many ranks of a program that does nothing, as an attempt would be started. Why this does not
/// work, in mpirun's own words; empty when it does. Waits a minute at most.
[[nodiscard]] std::string trouble_with_launch(const std::filesystem::path& mpirun, int ranks);

}  // namespace softwall::campaign
