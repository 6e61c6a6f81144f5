#include "solver/output/cell_plane.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace softwall::output {
namespace {

/// Cells of the plane in x, y and z: 1 across it.
std::array<int, 3> size_of(const CellPlane& plane, const grid::Grid& g) {
  std::array<int, 3> size{g.nx_global, g.ny, g.nz_global};
  size[static_cast<std::size_t>(plane.axis)] = 1;
  return size;
}

/// This rank's share of the plane along one axis, in its own indices.
parallel::Range own_range(const CellPlane& plane, int axis, int begin, int cells) {
  if (axis != plane.axis) return {0, cells};
  const int own = plane.index - begin;
  return own >= 0 && own < cells ? parallel::Range{own, own + 1} : parallel::Range{0, 0};
}

double center(int axis, int n, const grid::Grid& g) {
  if (axis == 1) return g.y_center[n];
  return (n + 0.5) * (axis == 0 ? g.dx : g.dz);
}

}  // namespace

std::array<int, 2> CellPlane::shape(const grid::Grid& g) const {
  if (axis == 0) return {g.nz_global, g.ny};
  return {axis == 1 ? g.nz_global : g.ny, g.nx_global};
}

CellPlane nearest_plane(int axis, double position, const grid::Grid& g) {
  const int cells = std::array{g.nx_global, g.ny, g.nz_global}[static_cast<std::size_t>(axis)];
  CellPlane nearest{axis, 0, center(axis, 0, g)};
  for (int n = 1; n < cells; ++n) {
    const double here = center(axis, n, g);
    if (std::abs(here - position) < std::abs(nearest.position - position)) nearest = {axis, n, here};
  }
  return nearest;
}

std::vector<float> gather_plane(const CellPlane& plane, const grid::Grid& g,
                                const parallel::Communicator& all, const CellValue& value) {
  const auto [nx, ny, nz] = size_of(plane, g);
  std::vector<float> values(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) *
                            static_cast<std::size_t>(nz));
  const parallel::Range x = own_range(plane, 0, g.x_begin, g.nx), y = own_range(plane, 1, 0, g.ny),
                        z = own_range(plane, 2, g.z_begin, g.nz);
  const auto place = [&](int axis, int n, int begin) {
    return static_cast<std::size_t>(axis == plane.axis ? 0 : begin + n);
  };
  for (int k = z.begin; k < z.end; ++k) {
    for (int j = y.begin; j < y.end; ++j) {
      const std::size_t row = place(2, k, g.z_begin) * static_cast<std::size_t>(ny) + place(1, j, 0);
      for (int i = x.begin; i < x.end; ++i)
        values[row * static_cast<std::size_t>(nx) + place(0, i, g.x_begin)] = value(i, j, k);
    }
  }
  // Each number comes from one rank, and all bits of the others are 0. A sum would lose the sign of a zero.
  static_assert(sizeof(float) == sizeof(std::uint32_t));
  const bool root = all.rank() == 0;
  parallel::check(MPI_Reduce(root ? MPI_IN_PLACE : values.data(), values.data(),
                             static_cast<int>(values.size()), MPI_UINT32_T, MPI_BOR, 0, all.get()),
                  "MPI_Reduce");
  return values;
}

}  // namespace softwall::output
