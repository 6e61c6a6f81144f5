#pragma once

#include <filesystem>
#include <string>

namespace softwall::output {

/// A file of planes as one moment of a collection, for ParaView: each plane and the interface at rest as a
/// grid of the cell centres, one point thick, where it lies in the box. (ParaView 5.11 does not read numbers
/// of cells on such a grid, nor those of its points in two dimensions.) Throws std::runtime_error where it
/// cannot be read.
[[nodiscard]] std::string film_in_xdmf(const std::filesystem::path& file);

}  // namespace softwall::output
