#pragma once

#include <filesystem>

/// solver.log of a run directory, into which all attempts write, is kept below 16 MiB; what was in it before
/// stays beside it, as solver.log.old.
namespace softwall::campaign {

/// A log that many attempts have written into makes room for a new one.
void keep_small(const std::filesystem::path& log);

/// Makes room in a log while an attempt writes it. The attempt appends, so that it goes on at the new end.
/// What it writes between the two steps is lost, and so is the copy where the disk is full.
void keep_small_while_written(const std::filesystem::path& log);

}  // namespace softwall::campaign
