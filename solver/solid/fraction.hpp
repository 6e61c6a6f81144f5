#pragma once

#include "solver/grid/field.hpp"

/// Solid fraction at centers and, volume-weighted, on the edges where shear stress lives.
namespace softwall::solid {

using grid::Real;
using grid::View;

struct Fraction {
  View<const Real> phi;
  const Real* upper_share;  ///< share of row j in the control volume around face j

  Real center(int i, int j, int k) const { return phi(i, j, k); }
  Real edge_xy(int i, int j, int k) const {
    return (upper_share[j] * (phi(i, j, k) + phi(i - 1, j, k)) +
            (1 - upper_share[j]) * (phi(i, j - 1, k) + phi(i - 1, j - 1, k))) /
           2;
  }
  Real edge_xz(int i, int j, int k) const {
    return (phi(i, j, k) + phi(i - 1, j, k) + phi(i, j, k - 1) + phi(i - 1, j, k - 1)) / 4;
  }
  Real edge_yz(int i, int j, int k) const {
    return (upper_share[j] * (phi(i, j, k) + phi(i, j, k - 1)) +
            (1 - upper_share[j]) * (phi(i, j - 1, k) + phi(i, j - 1, k - 1))) /
           2;
  }
};

}  // namespace softwall::solid
