#pragma once

#include <array>
#include <vector>

#include "solver/grid/field.hpp"

/// The surface of the solid as a height over each column: the material surface y - d_y = its height at rest.
namespace softwall::solid::reference_map {

using grid::Grid;
using grid::Real;

using grid::View;

/// Heights eta of the surface over the centers of this rank's columns and `ghost` more on every side, h.
class Heights {
 public:
  Heights(const Grid& grid, int ghost);

  [[nodiscard]] double operator()(int i, int k) const { return row(k)[i]; }
  /// Address of column (0, k).
  [[nodiscard]] const double* row(int k) const { return values_.data() + offset(k); }

  /// 1 / (1 + r^2), with r the rise of the surface from a column to the next over `row_height`: 1 where it is
  /// flat. For columns with neighbours on all sides.
  [[nodiscard]] double flatness(int i, int k, double row_height) const {
    const double in_x = (row(k)[i + 1] - row(k)[i - 1]) / (2 * row_height),
                 in_z = (row(k + 1)[i] - row(k - 1)[i]) / (2 * row_height);
    return 1 / (1 + in_x * in_x + in_z * in_z);
  }

  /// Follows every column down from the upper wall to where y - d_y first falls to `at_rest`, linear between
  /// faces; where it never does, the solid reaches the lower wall. `displacement`: d_y on y faces.
  void find(const grid::Field& displacement, double at_rest);
  /// The lowest over this rank's own columns, and the sum over them.
  [[nodiscard]] double lowest() const;
  [[nodiscard]] double sum() const;

 private:
  [[nodiscard]] std::ptrdiff_t offset(int k) const { return std::ptrdiff_t(k + ghost_) * stride_ + ghost_; }
  const Grid& grid_;
  int ghost_;
  std::ptrdiff_t stride_;
  std::vector<double> values_;
};

/// phi: the share of each cell that lies above the surface, taken bilinear between the centers of columns and
/// measured on 4 x 4 strips of each column. Over a column phi adds up to the mean depth of its strips
/// exactly.
class CellFractions {
 public:
  explicit CellFractions(const Grid& grid);

  /// Rows j0 <= j < ny, in this rank's columns and one more on every side (heights: two more). Returns the
  /// row from which on all is solid.
  int fill(const Heights& heights, int j0, grid::Field& phi);

 private:
  static constexpr int kStrips = 4;
  /// Between which heights the surface lies over the columns of one z.
  struct Range {
    double lowest, highest;
  };
  Range find_strips(const Heights& heights, int k);
  void fill_crossed_row(double bottom, double top, Real* phi) const;

  const Grid& grid_;
  /// Heights over the strips of the columns -1 <= i <= nx of one line, stored from element 0 on.
  std::array<std::vector<double>, std::size_t{kStrips} * kStrips> strips_;
};

}  // namespace softwall::solid::reference_map
