#pragma once

#include <filesystem>

#include "solver/run_directory/block_statistics.hpp"

/// statistics.h5, written by the solver, read by the manager and by the plotting scripts.
namespace softwall::analysis {

/// Replace `path` by these statistics: temporary, fsync, rename, fsync of the folder, so that a reader sees
/// the old or the new file and never half of one. MPI need not be initialised. Throws
/// std::runtime_error naming the file and what is wrong.
void write_statistics(const std::filesystem::path& path, const BlockStatistics& statistics);

/// Read what write_statistics wrote, bit for bit.
/// Throws std::runtime_error naming the file and what is wrong with it; never trusts a size that it has not
/// checked.
[[nodiscard]] BlockStatistics read_statistics(const std::filesystem::path& path);

}  // namespace softwall::analysis
