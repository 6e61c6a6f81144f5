#pragma once

#include "solver/grid/field.hpp"

/// The velocities that carry a quantity through the faces of its control volume. Centers use the cell's own
/// faces. The control volume of an edge quantity consists of four quarters of cells; within a cell each
/// component is taken linear in its own direction and constant in the others, so the volume's net outflow is
/// the mean divergence of the four cells: constants stay constant to round-off. x(i,j,k), y(i,j,k), z(i,j,k):
/// normal velocity on the low face of the control volume of point (i,j,k).
namespace softwall::solid {

using grid::Real;
using grid::View;

struct Velocity {
  View<const Real> u, v, w;
  const Real* upper_share;  ///< share of row j in the height between centers j-1 and j

  /// Interpolation of a quantity constant in each cell height to the control volume around face j.
  template <class Q>
  Real across_y(int j, const Q& q) const {
    return upper_share[j] * q(j) + (1 - upper_share[j]) * q(j - 1);
  }
  Real u_center(int i, int j, int k) const { return (u(i, j, k) + u(i + 1, j, k)) / 2; }
  Real v_center(int i, int j, int k) const { return (v(i, j, k) + v(i, j + 1, k)) / 2; }
  Real w_center(int i, int j, int k) const { return (w(i, j, k) + w(i, j, k + 1)) / 2; }
};

struct CenterVelocity : Velocity {
  static constexpr bool kOnYFace = false;
  Real x(int i, int j, int k) const { return u(i, j, k); }
  Real y(int i, int j, int k) const { return v(i, j, k); }
  Real z(int i, int j, int k) const { return w(i, j, k); }
};

struct EdgeXyVelocity : Velocity {
  static constexpr bool kOnYFace = true;
  Real x(int i, int j, int k) const {
    return across_y(j, [=, this](int row) { return u_center(i - 1, row, k); });
  }
  Real y(int i, int j, int k) const { return (v_center(i - 1, j - 1, k) + v_center(i, j - 1, k)) / 2; }
  Real z(int i, int j, int k) const {
    return across_y(j, [=, this](int row) { return (w(i - 1, row, k) + w(i, row, k)) / 2; });
  }
};

struct EdgeXzVelocity : Velocity {
  static constexpr bool kOnYFace = false;
  Real x(int i, int j, int k) const { return (u_center(i - 1, j, k - 1) + u_center(i - 1, j, k)) / 2; }
  Real y(int i, int j, int k) const {
    return (v(i, j, k) + v(i - 1, j, k) + v(i, j, k - 1) + v(i - 1, j, k - 1)) / 4;
  }
  Real z(int i, int j, int k) const { return (w_center(i - 1, j, k - 1) + w_center(i, j, k - 1)) / 2; }
};

struct EdgeYzVelocity : Velocity {
  static constexpr bool kOnYFace = true;
  Real x(int i, int j, int k) const {
    return across_y(j, [=, this](int row) { return (u(i, row, k - 1) + u(i, row, k)) / 2; });
  }
  Real y(int i, int j, int k) const { return (v_center(i, j - 1, k - 1) + v_center(i, j - 1, k)) / 2; }
  Real z(int i, int j, int k) const {
    return across_y(j, [=, this](int row) { return w_center(i, row, k - 1); });
  }
};

}  // namespace softwall::solid
