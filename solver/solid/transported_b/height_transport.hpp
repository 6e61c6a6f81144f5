#pragma once

#include "solver/grid/stage.hpp"
#include "solver/solid/transported_b/column_heights.hpp"

/// Transport of phi as a height: the surface of the solid is one height eta over each column, and the
/// column's volume of solid changes by what flows in through its sides,
///   d eta/dt = d/dx int_eta^top u dy + d/dz int_eta^top w dy,
/// in flux form, so that the volume of the solid is constant to round-off as long as no column runs empty.
/// The height on a face is WENO's value from the side that the velocity at the surface comes from. phi is the
/// share of each cell above the surface: the interface is as sharp at the end as it was at the beginning, and
/// a small wave is moved by the velocity at the surface exactly, however small it is. A surface that would
/// fold stays a steep step.
///
/// Upwinding by the velocity of the surface hardly damps what is a few columns long, because surface and
/// stress are two fields that only waves couple: single columns grew out of the surface. So each flow has the
/// dissipation that a linear fifth-order upwind scheme has for waves of speed c = sqrt(G),
///   d eta/dt = ... + c/60 (dx^5 d^6 eta/dx^6 + dz^5 d^6 eta/dz^6),
/// which in a time dx/c takes 0.3 % from a wave eight columns long, 13 % of four and 66 % of two.
namespace softwall::solid {

class HeightTransport {
 public:
  /// wave_speed: of shear waves in the solid, U_b.
  HeightTransport(const Grid& grid, grid::Halo& halo, WenoWeights weights, double wave_speed);

  /// Finds the surface of phi, whose ghost cells are filled: before the first substep, and after each one.
  void follow(const grid::Field& phi, int first_row) { surface_.find(phi, first_row); }

  /// One substep of the surface that was found last, and of phi in rows from first_row on. Ghost cells of the
  /// velocity: filled on entry; those of phi: not on return.
  void advance(grid::Field& phi, const grid::VectorField& velocity, const Stage& stage, double dt,
               int first_row);

  [[nodiscard]] const ColumnHeights& surface() const { return surface_; }

 private:
  template <WenoWeights kWeights>
  void find_flows(const grid::VectorField& velocity, int first_row);
  template <WenoWeights kWeights>
  void find_line_of_flows(const View<const Real>& velocity, const Real* heights, std::ptrdiff_t stride, int k,
                          int first_row, int end, Real* flow);
  void find_rates(const grid::VectorField& velocity, int first_row);

  const Grid& grid_;
  WenoWeights weights_;
  Real wave_speed_;
  ColumnHeights surface_;
  grid::Field flow_x_, flow_z_;  ///< of the solid through the low faces of the columns; a single row
  grid::Field now_, before_;     ///< d eta/dt; a single row
  std::vector<Real> from_low_, from_high_, flow_high_, speed_;  ///< along one line of faces
};

}  // namespace softwall::solid
