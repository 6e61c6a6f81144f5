#pragma once

#include "solver/output/collection.hpp"
#include "solver/run_directory/run_files.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::output {

/// Writes fields/fields-<step>.h5, all at cell centres: velocity, p and, with a solid, phi and what carries
/// its deformation (displacement or B); and fields/fields.xdmf, the collection of all snapshots that ParaView
/// opens. Collective. Not part of the state: a snapshot that already exists is replaced. I/O errors end the
/// program with exit code 75.
void write_snapshot(const RunFiles& run, const time::State& state, time::Setup& setup,
                    Collection& collection);

/// The collection of all snapshots of a run.
[[nodiscard]] Collection collection_of_snapshots(const RunFiles& run);

}  // namespace softwall::output
