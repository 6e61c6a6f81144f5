#pragma once

#include <filesystem>

namespace softwall::output {

/// Writes <folder>/fields.xdmf anew: one collection in time of all fields-*.h5 in the folder, for ParaView.
/// What they hold is asked of the files, so that those of a resumed run, or of an earlier version, are in it;
/// one that cannot be read is left out. On one rank. Throws std::system_error when it cannot be written.
void write_snapshot_collection(const std::filesystem::path& folder);

}  // namespace softwall::output
