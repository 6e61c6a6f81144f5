#pragma once

#include <vector>

#include "solver/solid/transported_b/transport_velocity.hpp"
#include "solver/solid/weno.hpp"

/// Transport in flux form: rate = -div(velocity q), face velocity times upwind WENO value, each face computed
/// once. In flux form the sum of q is conserved to round-off and constants stay constant.
namespace softwall::solid {

using grid::Grid;

class Advection {
 public:
  Advection(const Grid& grid, WenoWeights weights);

  /// Writes the rate of q in rows first_row <= j < ny (y-face quantities: from max(first_row, 1)).
  /// Nothing crosses the low face of a first row above the wall, nor the walls.
  template <class PointVelocity>
  void rate_of(const grid::Field& q, const PointVelocity& velocity, int first_row, grid::Field& rate);

 private:
  template <WenoWeights kWeights, class PointVelocity>
  void sweep(View<const Real> q, const PointVelocity& velocity, int first_row, View<Real> rate);

  const Grid& grid_;
  WenoWeights weights_;
  std::vector<Real> flux_x_, flux_y_[2], flux_z_[2];  ///< a row; low and high row; low and high plane
};

}  // namespace softwall::solid
