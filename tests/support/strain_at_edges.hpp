#pragma once

#include "solver/solid/reference_map/strain.hpp"

/// A on the edges of the grid, each found alone: what StrainSweep, which shares means between places, must
/// find. (i, j, k) names the low corner's edge, as for the velocity.
namespace softwall::solid::reference_map {

inline Real across_y(const Strain& s, int j, Real upper, Real lower) {
  return s.upper_share[j] * upper + (1 - s.upper_share[j]) * lower;
}

inline MapGradient edge_xy(const Strain& s, int i, int j, int k) {
  const auto &x = s.x, &y = s.y, &z = s.z;
  const auto wide_x = [&](int b) { return x(i + 1, b, k) - x(i - 1, b, k); };
  const auto wide_xz = [&](int b) { return x(i, b, k + 1) - x(i, b, k - 1); };
  const auto two_z = [&](int a, int b) { return z(a, b, k) + z(a, b, k + 1); };
  const auto wide_z = [&](int b) {
    return z(i, b, k + 1) - z(i, b, k) + z(i - 1, b, k + 1) - z(i - 1, b, k);
  };
  return {
      1 - across_y(s, j, wide_x(j), wide_x(j - 1)) / 2 * s.inv_dx,
      -(x(i, j, k) - x(i, j - 1, k)) * s.inv_dy_face[j],
      -across_y(s, j, wide_xz(j), wide_xz(j - 1)) / 2 * s.inv_dz,
      -(y(i, j, k) - y(i - 1, j, k)) * s.inv_dx,
      1 - (y(i, j + 1, k) - y(i, j - 1, k) + y(i - 1, j + 1, k) - y(i - 1, j - 1, k)) / 4 * s.inv_dy_face[j],
      -(y(i, j, k + 1) - y(i, j, k - 1) + y(i - 1, j, k + 1) - y(i - 1, j, k - 1)) / 4 * s.inv_dz,
      -across_y(s, j, two_z(i, j) - two_z(i - 1, j), two_z(i, j - 1) - two_z(i - 1, j - 1)) / 2 * s.inv_dx,
      -(two_z(i, j) - two_z(i, j - 1) + two_z(i - 1, j) - two_z(i - 1, j - 1)) / 4 * s.inv_dy_face[j],
      1 - across_y(s, j, wide_z(j), wide_z(j - 1)) / 2 * s.inv_dz};
}

inline MapGradient edge_xz(const Strain& s, int i, int j, int k) {
  const auto &x = s.x, &y = s.y, &z = s.z;
  const auto two_y = [&](int a, int c) { return y(a, j, c) + y(a, j + 1, c); };
  const auto high_y = [&](int a, int c) { return (y(a, j + 1, c) - y(a, j, c)) * s.inv_dy[j]; };
  const auto in_y = [&](const View<const Real>& q, int a, int c) {
    return ((q(a, j + 1, c) - q(a, j, c)) * s.inv_dy_face[j + 1] +
            (q(a, j, c) - q(a, j - 1, c)) * s.inv_dy_face[j]) /
           2;
  };
  return {1 - (x(i + 1, j, k) - x(i - 1, j, k) + x(i + 1, j, k - 1) - x(i - 1, j, k - 1)) / 4 * s.inv_dx,
          -(in_y(x, i, k) + in_y(x, i, k - 1)) / 2,
          -(x(i, j, k) - x(i, j, k - 1)) * s.inv_dz,
          -(two_y(i, k) - two_y(i - 1, k) + two_y(i, k - 1) - two_y(i - 1, k - 1)) / 4 * s.inv_dx,
          1 - (high_y(i, k) + high_y(i - 1, k) + high_y(i, k - 1) + high_y(i - 1, k - 1)) / 4,
          -(two_y(i, k) - two_y(i, k - 1) + two_y(i - 1, k) - two_y(i - 1, k - 1)) / 4 * s.inv_dz,
          -(z(i, j, k) - z(i - 1, j, k)) * s.inv_dx,
          -(in_y(z, i, k) + in_y(z, i - 1, k)) / 2,
          1 - (z(i, j, k + 1) - z(i, j, k - 1) + z(i - 1, j, k + 1) - z(i - 1, j, k - 1)) / 4 * s.inv_dz};
}

inline MapGradient edge_yz(const Strain& s, int i, int j, int k) {
  const auto &x = s.x, &y = s.y, &z = s.z;
  const auto wide_z = [&](int b) { return z(i, b, k + 1) - z(i, b, k - 1); };
  const auto wide_zx = [&](int b) { return z(i + 1, b, k) - z(i - 1, b, k); };
  const auto two_x = [&](int b, int c) { return x(i, b, c) + x(i + 1, b, c); };
  const auto wide_x = [&](int b) {
    return x(i + 1, b, k) - x(i, b, k) + x(i + 1, b, k - 1) - x(i, b, k - 1);
  };
  return {
      1 - across_y(s, j, wide_x(j), wide_x(j - 1)) / 2 * s.inv_dx,
      -(two_x(j, k) - two_x(j - 1, k) + two_x(j, k - 1) - two_x(j - 1, k - 1)) / 4 * s.inv_dy_face[j],
      -across_y(s, j, two_x(j, k) - two_x(j, k - 1), two_x(j - 1, k) - two_x(j - 1, k - 1)) / 2 * s.inv_dz,
      -(y(i + 1, j, k) - y(i - 1, j, k) + y(i + 1, j, k - 1) - y(i - 1, j, k - 1)) / 4 * s.inv_dx,
      1 - (y(i, j + 1, k) - y(i, j - 1, k) + y(i, j + 1, k - 1) - y(i, j - 1, k - 1)) / 4 * s.inv_dy_face[j],
      -(y(i, j, k) - y(i, j, k - 1)) * s.inv_dz,
      -across_y(s, j, wide_zx(j), wide_zx(j - 1)) / 2 * s.inv_dx,
      -(z(i, j, k) - z(i, j - 1, k)) * s.inv_dy_face[j],
      1 - across_y(s, j, wide_z(j), wide_z(j - 1)) / 2 * s.inv_dz};
}

}  // namespace softwall::solid::reference_map
