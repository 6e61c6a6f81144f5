#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::statistics {

/// u, v, w, p, eta of a column of cells at the mean height of the interface, less their means over the plane.
/// Units: h, U_b, density 1.
using InterfaceColumn = std::array<double, 5>;

/// Those of this rank, i + nx k. eta is the height of the interface (interface_height.hpp), `heights` over
/// this rank's columns; u, v, w, p stand at the height of the flat interface over the middle of each column,
/// v as it is on the face there, the others as means of their neighbours, between the rows on both sides
/// linear in y. Collective; ghost cells filled.
[[nodiscard]] std::vector<InterfaceColumn> interface_columns(const time::State& state,
                                                             std::span<const double> heights,
                                                             const time::Setup& setup);

}  // namespace softwall::statistics
