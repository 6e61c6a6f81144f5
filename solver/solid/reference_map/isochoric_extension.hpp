#pragma once

#include <vector>

#include "solver/solid/reference_map/surface.hpp"

/// Keeps the volume where the displacement was extrapolated. Straight lines down neighbouring columns change
/// the volume under a steep surface: there det A was between 0.4 and 1.2 in the cells that the surface cuts
/// (G = 0.25 on 72 x (72 + 18) x 72 cells), the surface swept such cells into the solid, and they ended the
/// run. So d_y is found once more in the cells below the surface, from the surface down, such that
///   det A = A_yy (A_xx A_zz - A_xz A_zx) + terms without A_yy = 1
/// with all other gradients those of the straight lines. With that, det A stays between 0.95 and 1.04 in
/// those cells while slopes are below 0.7 (96 x (96 + 24) x 96 cells).
namespace softwall::solid::reference_map {

class IsochoricExtension {
 public:
  explicit IsochoricExtension(const Grid& grid);

  /// Changes d_y on y faces below the surface, down to row j0, of this rank's columns. Reads the extrapolated
  /// displacement and its ghost cells; those of d_y have to be filled again.
  void apply(const Heights& heights, int j0, grid::VectorField& displacement);

 private:
  struct Line;
  int find_changes(const Heights& heights, int j0, int k, const grid::VectorField& displacement);
  int find_row(const Line& line, int j, const grid::VectorField& displacement);
  void move_on(const Line& line, int j);

  const Grid& grid_;
  grid::Field change_;           ///< of d_y
  std::vector<Real> lift_;       ///< change of d_y on the face above, over a line of columns
  std::vector<int> cells_left_;  ///< of each column, in which det A is still to be set
  std::vector<int> top_row_;     ///< of each plane: no face from this row on is below the surface
};

}  // namespace softwall::solid::reference_map
