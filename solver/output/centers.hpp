#pragma once

#include <array>
#include <vector>

#include "solver/grid/field.hpp"

/// Faces and centres of the cells, for files that have all quantities at the centres.
namespace softwall::output {

/// Which neighbours of a value lie at the other ends of the cell, in x, y and z: {1, 0, 0} of a low-x face,
/// {1, 1, 0} of a low-x low-y edge, {0, 0, 0} of the centre.
using Place = std::array<int, 3>;

/// Mean over all ends of one cell, of a quantity whose ghost cells are filled.
inline grid::Real at_center(const grid::View<const grid::Real>& q, const Place& place, int i, int j, int k) {
  const int x = place[0], y = place[1], z = place[2];
  grid::Real sum = 0;
  for (int c = 0; c <= z; ++c)
    for (int b = 0; b <= y; ++b)
      for (int a = 0; a <= x; ++a) sum += q(i + a, j + b, k + c);
  return sum / static_cast<grid::Real>((1 + x) * (1 + y) * (1 + z));
}

/// Where the faces of all cells of all ranks lie, h: one more than cells in each direction.
struct CellFaces {
  std::vector<double> x, y, z;
};

inline CellFaces faces_of(const grid::Grid& g) {
  CellFaces faces;
  for (int i = 0; i <= g.nx_global; ++i) faces.x.push_back(i * g.dx);
  for (int j = 0; j <= g.ny; ++j) faces.y.push_back(g.y_face[j]);
  for (int k = 0; k <= g.nz_global; ++k) faces.z.push_back(k * g.dz);
  return faces;
}

}  // namespace softwall::output
