#pragma once

#include <array>
#include <vector>

#include "solver/grid/halo.hpp"

/// The surface of the solid as one height over each column, known from the column's volume of solid, and the
/// fractions that follow from it. Heights are counted from the interface of the undeformed layer, so that
/// single precision, too, resolves waves of any amplitude.
namespace softwall::solid {

using grid::Grid;
using grid::Real;
using grid::View;

/// For fields with one number in each column.
[[nodiscard]] inline Grid single_row(Grid g) {
  g.ny = 1;
  return g;
}

class ColumnHeights {
 public:
  static constexpr int kGhost = 3;  ///< columns on every side: as many as WENO reads

  ColumnHeights(const Grid& grid, grid::Halo& halo);

  /// Takes the heights from phi: the top of the highest row without solid and the sum of (1 - phi) dy above
  /// it, so that a surface on a face is found there exactly. Ghost cells of phi filled; no solid below
  /// first_row.
  void find(const grid::Field& phi, int first_row);

  /// The inverse. Within its column the surface is a plane with the slopes of the heights around it, measured
  /// on 4 x 4 strips, whose mean is the height itself: what find() takes from phi was put there, to
  /// round-off, as long as the height is between the wall and first_row. Writes rows from first_row on of
  /// this rank's columns. Fills the ghost columns of the heights.
  void put(grid::Field& phi, int first_row);

  /// Height over column (i, k) is height(i, 0, k), h above the undeformed interface.
  [[nodiscard]] View<Real> view() { return heights_.view(); }
  [[nodiscard]] View<const Real> view() const { return heights_.view(); }
  /// Heights of the faces between rows, counted in the same way; row 0 at the beginning.
  [[nodiscard]] const std::vector<Real>& faces() const { return faces_; }

  /// 1 / (1 + r^2), with r the rise of the surface from a column to the next in heights of a row at the
  /// undeformed interface: 1 where it is flat. For columns with neighbours on all sides.
  [[nodiscard]] double flatness(int i, int k) const;

 private:
  static constexpr int kStrips = 4;
  /// Between which heights the surface lies over the columns of one z.
  struct Range {
    Real lowest, highest;
  };
  /// Where a strip lies between the sides of its column, from -1/2 to 1/2.
  static Real offset_of(int strip) { return (strip + Real(0.5)) / kStrips - Real(0.5); }
  void find_slopes(int k, Real lowest);
  Range find_strips(int k);
  void put_crossed_row(int j, Real* phi) const;

  const Grid& grid_;
  grid::Halo& halo_;
  grid::Field heights_;  ///< a single row
  std::vector<Real> faces_;
  std::vector<double> bases_, fluid_;  ///< of one line of columns: highest row without solid; fluid above it
  std::vector<Real> slope_x_, slope_z_;  ///< rise across a column of the line
  std::array<std::vector<Real>, std::size_t{kStrips} * kStrips> strips_;  ///< heights along one line
  Real row_height_;
};

}  // namespace softwall::solid
