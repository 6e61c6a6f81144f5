#pragma once

#include <cstdint>

#include "solver/case/case.hpp"

namespace softwall {

/// Bytes of the fields in one checkpoint of this case, to know before a run whether they fit on the disk. The
/// header, the statistics and HDF5's own tables come on top; they are small beside the fields of any real
/// grid.
[[nodiscard]] std::int64_t checkpoint_field_bytes(const Physics& physics);

/// The same of one snapshot (output/README.md), all of whose fields are at cell centers.
[[nodiscard]] std::int64_t snapshot_field_bytes(const Physics& physics);

/// The same of one moment of a film, whose numbers are in single precision always; 0: no film.
[[nodiscard]] std::int64_t film_moment_bytes(const Physics& physics, const PlaneSpec& planes);

}  // namespace softwall
