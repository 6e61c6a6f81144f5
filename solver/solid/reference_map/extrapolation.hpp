#pragma once

#include <vector>

#include "solver/solid/reference_map/surface.hpp"

/// The displacement below the surface: gradients in partly filled cells and the stencils of transport read
/// it, but the fluid has none. So it goes on along each column in a straight line from the lowest point in
/// the solid (y is whole on every rank, and the solid is the top of every column).
///
/// The slope of the line is that between the two lowest points of the solid, but at most 0.3 from that over a
/// height of half the horizontal spacing. Between two neighbouring points of thin cells alone it would follow
/// every error of the lowest one, which transport then carries back into the solid: on 72 x (72 + 18) x 72
/// cells, five times as long as high, the layer of G = 0.25 came apart at t = 19 that way. The slope is also
/// kept within bounds far from ordinary values, |d(d_x)/dy| <= 2 and -1 <= d(d_y)/dy <= 1/2: where points are
/// torn apart, the line must not let the surface run away along the column.
namespace softwall::solid::reference_map {

class Extrapolation {
 public:
  explicit Extrapolation(const Grid& grid);

  /// Extrapolates the three components, where they live, down to row j0. heights: one column more at low x
  /// and low z. `displacement` on the upper wall must be set; ghost columns are not written.
  void extend(const Heights& heights, int j0, grid::VectorField& displacement);

 private:
  struct Bounds;
  template <class SurfaceAt>
  void extend(View<Real> d, const grid::RowArray& y, int j0, const Bounds& slopes, const SurfaceAt& surface);
  [[nodiscard]] int upper_end_of_slope(const grid::RowArray& y, int j) const;

  const Grid& grid_;
  double slope_height_;          ///< over which slopes are held, at least, h
  std::vector<double> surface_;  ///< its heights over a line of points
  std::vector<Real> slope_;      ///< of the lines through them
};

}  // namespace softwall::solid::reference_map
