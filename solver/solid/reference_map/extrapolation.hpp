#pragma once

#include <vector>

#include "solver/solid/reference_map/surface.hpp"

/// The displacement below the surface: gradients in partly filled cells and the stencils of transport read
/// it, but the fluid has none. So it goes on along each column in a straight line from the lowest point in
/// the solid (y is whole on every rank, and the solid is the top of every column).
///
/// The slope of the line is that between the two lowest points of the solid, but at most 0.1 from that of a
/// parabola through the lowest point and two above it, half a horizontal spacing apart or a little more.
/// Between two neighbouring points of thin cells alone it would follow every error of the lowest one, which
/// transport then carries back into the solid: on 72 x (72 + 18) x 72 cells, five times as long as high, the
/// layer of G = 0.25 came apart at t = 19 that way. A straight line over the same height instead of the
/// parabola is of first order where d bends: the energy of a driven layer was then missed by 1.1 %. The slope
/// is also kept within bounds far from ordinary values, |d(d_x)/dy| <= 2 and -1 <= d(d_y)/dy <= 1/2: where
/// points are torn apart, the line must not let the surface run away along the column.
namespace softwall::solid::reference_map {

class Extrapolation {
 public:
  explicit Extrapolation(const Grid& grid);

  /// Extrapolates the three components, where they live, down to row j0. heights: one column more at low x
  /// and low z. `displacement` on the upper wall must be set; ghost columns are not written.
  void extend(const Heights& heights, int j0, grid::VectorField& displacement);

 private:
  struct Bounds;
  struct Parabola {  ///< rows and weights of its slope at a row below them, 1/h
    int nearer, farther;
    Real near, far;
  };
  template <class SurfaceAt>
  void extend(View<Real> d, const grid::RowArray& y, int j0, const Bounds& slopes, const SurfaceAt& surface);
  [[nodiscard]] int row_above(const grid::RowArray& y, int j, double height) const;
  [[nodiscard]] Parabola parabola_at(const grid::RowArray& y, int j) const;

  const Grid& grid_;
  double span_;                  ///< between the points of a parabola, at least, h
  std::vector<double> surface_;  ///< its heights over a line of points
  std::vector<Real> slope_;      ///< of the lines through them
};

}  // namespace softwall::solid::reference_map
