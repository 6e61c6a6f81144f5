#pragma once

#include <filesystem>
#include <string>

namespace softwall::output {

/// A snapshot as one moment of a collection, for ParaView. What it holds is asked of the file, so that one of
/// an earlier version is described as it is. Throws std::runtime_error where it cannot be read.
[[nodiscard]] std::string snapshot_in_xdmf(const std::filesystem::path& file);

}  // namespace softwall::output
