#pragma once

#include "solver/case/case.hpp"
#include "solver/parallel/decomposition.hpp"

namespace softwall::time {

/// Times the part of a step that depends on the layout, a halo exchange and a projection, with every possible
/// layout of the case's grid and returns the fastest: the same answer on all ranks, but not always the same
/// from call to call. Collective; takes about ten substeps for each layout. There must be a possible one.
[[nodiscard]] parallel::Layout fastest_layout(const Physics& physics, const parallel::Communicator& world);

}  // namespace softwall::time
