#pragma once

#include <array>
#include <functional>
#include <vector>

#include "solver/grid/grid.hpp"
#include "solver/parallel/mpi.hpp"

namespace softwall::output {

/// A plane of cells of the whole grid, across one axis: 0, 1, 2 for x, y, z.
struct CellPlane {
  int axis = 0;
  int index = 0;        ///< of its cells along the axis, counted through all ranks
  double position = 0;  ///< of their centres, h

  /// Cells along the two other axes, slowest first: [nz][ny], [nz][nx] or [ny][nx].
  [[nodiscard]] std::array<int, 2> shape(const grid::Grid& grid) const;
};

/// The plane of cells whose centres are nearest to this position, h; of two that are equally near, the lower.
[[nodiscard]] CellPlane nearest_plane(int axis, double position, const grid::Grid& grid);

/// A number in single precision of one of this rank's cells.
using CellValue = std::function<float(int i, int j, int k)>;

/// The numbers of all cells of the plane on rank 0, row major in its shape; nothing of use elsewhere. They
/// are gathered bit by bit, so that the result does not depend on how the cells are shared. Collective.
[[nodiscard]] std::vector<float> gather_plane(const CellPlane& plane, const grid::Grid& grid,
                                              const parallel::Communicator& all, const CellValue& value);

}  // namespace softwall::output
