#pragma once

#include <cstdint>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/material.hpp"
#include "solver/solid/symmetric_tensor.hpp"

/// Keeps B symmetric positive definite.
namespace softwall::solid {

/// B at the center of a cell: its own normal components, the means of the surrounding shear components.
[[nodiscard]] SymmetricTensor tensor_at_center(const grid::TensorField& B, int i, int j, int k);

/// Where the smallest eigenvalue of B at a center has fallen below `floor`, adds the multiple of the identity
/// that brings it back to `floor`, and some millionths of the trace more: round-off must not ask for the same
/// cell again, so that a restart, which applies the limiter to limited cells, changes no bit. Only the cell's
/// own normal components change, and the added stress is a pressure: the limiter itself moves nothing. Shear
/// ghost cells must be filled. Returns the number of cells touched here.
std::int64_t keep_positive_definite(grid::TensorField& B, double floor, const grid::Box& box);

}  // namespace softwall::solid
