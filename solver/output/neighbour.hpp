#pragma once

#include <filesystem>

#include "solver/case/case.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

/// Starting a case from the end of one with the same grid and solid, but another G, viscosity or Reynolds
/// number; on any number of ranks.
namespace softwall::output {

/// The state of a case at time 0: flow and solid of the neighbour's checkpoint, bit for bit. The layer keeps
/// its shape and its deformation (displacement, or phi and B), so that its stress, which is G times a
/// function of them, jumps with G, and so does the viscous one with the viscosity: a transient follows, as
/// after a sudden change of material. Collective. Throws AgreedError: 78 when the checkpoint is missing, of
/// another case, grid, precision or formulation, 77 when it is damaged.
[[nodiscard]] time::State start_from_neighbour(const std::filesystem::path& checkpoint,
                                               const InitialSpec& initial, time::Setup& setup);

}  // namespace softwall::output
