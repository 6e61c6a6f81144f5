#pragma once

#include "solver/fluid/momentum.hpp"

/// R of momentum.hpp at one point: what MomentumSweep, which computes each flux once, must find.
namespace softwall::fluid {

/// R of the three components, on the low faces of cell (i, j, k).
inline Real momentum_x(const MomentumInput& m, int i, int j, int k) {
  return (flux_xx(m, i, j, k) - flux_xx(m, i - 1, j, k)) * m.inv_dx +
         (flux_xy(m, i, j + 1, k) - flux_xy(m, i, j, k)) * m.inv_dy[j] +
         (flux_xz(m, i, j, k + 1) - flux_xz(m, i, j, k)) * m.inv_dz;
}
inline Real momentum_y(const MomentumInput& m, int i, int j, int k) {
  return (flux_yx(m, i + 1, j, k) - flux_yx(m, i, j, k)) * m.inv_dx +
         (flux_yy(m, i, j, k) - flux_yy(m, i, j - 1, k)) * m.inv_dy_face[j] +
         (flux_yz(m, i, j, k + 1) - flux_yz(m, i, j, k)) * m.inv_dz;
}
inline Real momentum_z(const MomentumInput& m, int i, int j, int k) {
  return (flux_xz(m, i + 1, j, k) - flux_xz(m, i, j, k)) * m.inv_dx +
         (flux_zy(m, i, j + 1, k) - flux_zy(m, i, j, k)) * m.inv_dy[j] +
         (flux_zz(m, i, j, k) - flux_zz(m, i, j, k - 1)) * m.inv_dz;
}

}  // namespace softwall::fluid
