#pragma once

#include "solver/grid/field.hpp"

/// Stretching of the left Cauchy-Green tensor by the velocity gradient, paper eq:B-adv:
///   S_ij = B_ik du_j/dx_k + B_jk du_i/dx_k.
/// Each product B_ab du_c/dx_b is formed where both factors live, or on the nearest point where both average
/// to (edges for shear times shear in the plane, cell corners for shear out of the plane), and then averaged
/// to the component's own place. In simple shear B_xx at a center thus receives the mean of the squares of
/// the surrounding B_xy, never less than the square of their mean: B stays positive definite there by
/// construction.
///
/// The products at edges and corners that touch the fluid are left out of the means: there the velocity
/// gradient is the fluid's, which does not stretch the solid. (With it, B_xx beside an interface under a
/// steady shear flow grows without bound although the solid is at rest.)
namespace softwall::solid {

using grid::Real;
using grid::View;

struct Stretching {
  View<const Real> u, v, w;
  View<const Real> xx, yy, zz, xy, xz, yz;  ///< B
  View<const Real> in_xy, in_xz, in_yz;     ///< 1 on edges in the solid, 0 on those that touch the fluid
  const Real *inv_dy, *inv_dy_face, *dy, *dy_face;
  Real inv_dx, inv_dz;

  // Velocity gradients: normal ones at centers, shear ones on edges; (i, j, k) names the low corner's edge.
  Real dudx(int i, int j, int k) const { return (u(i + 1, j, k) - u(i, j, k)) * inv_dx; }
  Real dvdy(int i, int j, int k) const { return (v(i, j + 1, k) - v(i, j, k)) * inv_dy[j]; }
  Real dwdz(int i, int j, int k) const { return (w(i, j, k + 1) - w(i, j, k)) * inv_dz; }
  Real dudy(int i, int j, int k) const { return (u(i, j, k) - u(i, j - 1, k)) * inv_dy_face[j]; }
  Real dvdx(int i, int j, int k) const { return (v(i, j, k) - v(i - 1, j, k)) * inv_dx; }
  Real dudz(int i, int j, int k) const { return (u(i, j, k) - u(i, j, k - 1)) * inv_dz; }
  Real dwdx(int i, int j, int k) const { return (w(i, j, k) - w(i - 1, j, k)) * inv_dx; }
  Real dvdz(int i, int j, int k) const { return (v(i, j, k) - v(i, j, k - 1)) * inv_dz; }
  Real dwdy(int i, int j, int k) const { return (w(i, j, k) - w(i, j - 1, k)) * inv_dy_face[j]; }

  // Means over the points around a place that lie in the solid; 0 when none does. q is a callable (i, j, k).
  static Real mean_of_solid(Real sum, Real points) { return sum / (points > 1 ? points : Real(1)); }
  template <class Q>
  Real edges_xy(const Q& q, int i, int j, int k) const {  // four xy edges around a center
    const Real a = in_xy(i, j, k), b = in_xy(i + 1, j, k), c = in_xy(i, j + 1, k), d = in_xy(i + 1, j + 1, k);
    return mean_of_solid(a * q(i, j, k) + b * q(i + 1, j, k) + c * q(i, j + 1, k) + d * q(i + 1, j + 1, k),
                         a + b + c + d);
  }
  template <class Q>
  Real edges_xz(const Q& q, int i, int j, int k) const {
    const Real a = in_xz(i, j, k), b = in_xz(i + 1, j, k), c = in_xz(i, j, k + 1), d = in_xz(i + 1, j, k + 1);
    return mean_of_solid(a * q(i, j, k) + b * q(i + 1, j, k) + c * q(i, j, k + 1) + d * q(i + 1, j, k + 1),
                         a + b + c + d);
  }
  template <class Q>
  Real edges_yz(const Q& q, int i, int j, int k) const {
    const Real a = in_yz(i, j, k), b = in_yz(i, j + 1, k), c = in_yz(i, j, k + 1), d = in_yz(i, j + 1, k + 1);
    return mean_of_solid(a * q(i, j, k) + b * q(i, j + 1, k) + c * q(i, j, k + 1) + d * q(i, j + 1, k + 1),
                         a + b + c + d);
  }
  /// Mean of two corners. A corner is in the solid when the edges are whose shear is used there.
  template <class Q, class In>
  static Real corners(const Q& q, const In& in, int i, int j, int k, int i2, int j2, int k2) {
    const Real a = in(i, j, k), b = in(i2, j2, k2);
    return mean_of_solid(a * q(i, j, k) + b * q(i2, j2, k2), a + b);
  }
  /// Linear interpolation between rows j - 1 and j to face j.
  template <class Q>
  Real to_y_face(const Q& q, int i, int j, int k) const {
    return (q(i, j, k) * dy[j - 1] + q(i, j - 1, k) * dy[j]) / (2 * dy_face[j]);
  }
  template <class Q>
  static Real mean_x(const Q& q, int i, int j, int k) {
    return (q(i, j, k) + q(i - 1, j, k)) / 2;
  }
  template <class Q>
  static Real mean_z(const Q& q, int i, int j, int k) {
    return (q(i, j, k) + q(i, j, k - 1)) / 2;
  }

  // Normal components, at the center of cell (i, j, k).
  Real rate_xx(int i, int j, int k) const {
    const auto by_xy = [this](int a, int b, int c) { return xy(a, b, c) * dudy(a, b, c); };
    const auto by_xz = [this](int a, int b, int c) { return xz(a, b, c) * dudz(a, b, c); };
    return 2 * (xx(i, j, k) * dudx(i, j, k) + edges_xy(by_xy, i, j, k) + edges_xz(by_xz, i, j, k));
  }
  Real rate_yy(int i, int j, int k) const {
    const auto by_xy = [this](int a, int b, int c) { return xy(a, b, c) * dvdx(a, b, c); };
    const auto by_yz = [this](int a, int b, int c) { return yz(a, b, c) * dvdz(a, b, c); };
    return 2 * (yy(i, j, k) * dvdy(i, j, k) + edges_xy(by_xy, i, j, k) + edges_yz(by_yz, i, j, k));
  }
  Real rate_zz(int i, int j, int k) const {
    const auto by_xz = [this](int a, int b, int c) { return xz(a, b, c) * dwdx(a, b, c); };
    const auto by_yz = [this](int a, int b, int c) { return yz(a, b, c) * dwdy(a, b, c); };
    return 2 * (zz(i, j, k) * dwdz(i, j, k) + edges_xz(by_xz, i, j, k) + edges_yz(by_yz, i, j, k));
  }

  // Shear components on their edges: normal times shear gradient, shear times (minus) the third normal
  // gradient (du/dx + dv/dy = -dw/dz), and the two products that live on the corners at both ends of the
  // edge.
  Real rate_xy(int i, int j, int k) const {  // corners k and k + 1
    const auto xx_row = [this](int a, int b, int c) { return mean_x(xx, a, b, c); };
    const auto yy_row = [this](int a, int b, int c) { return mean_x(yy, a, b, c); };
    const auto dwdz_row = [this](int a, int b, int c) { return (dwdz(a, b, c) + dwdz(a - 1, b, c)) / 2; };
    const auto corner = [this](int a, int b, int c) {
      const auto dudz_here = [this](int l, int m, int n) { return dudz(l, m, n); };
      const auto dvdz_here = [this](int l, int m, int n) { return dvdz(l, m, n); };
      return to_y_face(xz, a, b, c) * mean_x(dvdz_here, a, b, c) +
             mean_x(yz, a, b, c) * to_y_face(dudz_here, a, b, c);
    };
    const auto in = [this](int a, int b, int c) {
      return in_yz(a, b, c) * in_yz(a - 1, b, c) * in_xz(a, b, c) * in_xz(a, b - 1, c);
    };
    return to_y_face(xx_row, i, j, k) * dvdx(i, j, k) + to_y_face(yy_row, i, j, k) * dudy(i, j, k) -
           xy(i, j, k) * to_y_face(dwdz_row, i, j, k) + corners(corner, in, i, j, k, i, j, k + 1);
  }
  Real rate_xz(int i, int j, int k) const {  // corners j and j + 1
    const auto xx_z = [this](int a, int b, int c) { return mean_z(xx, a, b, c); };
    const auto zz_z = [this](int a, int b, int c) { return mean_z(zz, a, b, c); };
    const auto dvdy_z = [this](int a, int b, int c) { return (dvdy(a, b, c) + dvdy(a, b, c - 1)) / 2; };
    const auto corner = [this](int a, int b, int c) {
      const auto dwdy_here = [this](int l, int m, int n) { return dwdy(l, m, n); };
      const auto dudy_here = [this](int l, int m, int n) { return dudy(l, m, n); };
      return mean_z(xy, a, b, c) * mean_x(dwdy_here, a, b, c) +
             mean_x(yz, a, b, c) * mean_z(dudy_here, a, b, c);
    };
    const auto in = [this](int a, int b, int c) {
      return in_yz(a, b, c) * in_yz(a - 1, b, c) * in_xy(a, b, c) * in_xy(a, b, c - 1);
    };
    return mean_x(xx_z, i, j, k) * dwdx(i, j, k) + mean_x(zz_z, i, j, k) * dudz(i, j, k) -
           xz(i, j, k) * mean_x(dvdy_z, i, j, k) + corners(corner, in, i, j, k, i, j + 1, k);
  }
  Real rate_yz(int i, int j, int k) const {  // corners i and i + 1
    const auto yy_z = [this](int a, int b, int c) { return mean_z(yy, a, b, c); };
    const auto zz_z = [this](int a, int b, int c) { return mean_z(zz, a, b, c); };
    const auto dudx_z = [this](int a, int b, int c) { return (dudx(a, b, c) + dudx(a, b, c - 1)) / 2; };
    const auto corner = [this](int a, int b, int c) {
      const auto dwdx_here = [this](int l, int m, int n) { return dwdx(l, m, n); };
      const auto dvdx_here = [this](int l, int m, int n) { return dvdx(l, m, n); };
      return mean_z(xy, a, b, c) * to_y_face(dwdx_here, a, b, c) +
             to_y_face(xz, a, b, c) * mean_z(dvdx_here, a, b, c);
    };
    const auto in = [this](int a, int b, int c) {
      return in_xz(a, b, c) * in_xz(a, b - 1, c) * in_xy(a, b, c) * in_xy(a, b, c - 1);
    };
    return to_y_face(yy_z, i, j, k) * dwdy(i, j, k) + to_y_face(zz_z, i, j, k) * dvdz(i, j, k) -
           yz(i, j, k) * to_y_face(dudx_z, i, j, k) + corners(corner, in, i, j, k, i + 1, j, k);
  }
  // On a rigid wall v = 0 and B_yy = 1 always, so that shear changes by the shear of the wall-parallel
  // velocity.
  Real rate_xy_wall(int i, int j, int k) const { return dudy(i, j, k); }
  Real rate_yz_wall(int i, int j, int k) const { return dwdy(i, j, k); }
};

/// 1 on edges in the solid, 0 on those that touch the fluid.
struct EdgeMarks {
  View<const Real> xy, xz, yz;
};

/// What the kernels read of these fields.
[[nodiscard]] inline Stretching stretching_of(const grid::TensorField& B, const grid::VectorField& velocity,
                                              const EdgeMarks& in, const grid::Grid& g) {
  return {.u = velocity.x.view(),
          .v = velocity.y.view(),
          .w = velocity.z.view(),
          .xx = B.xx.view(),
          .yy = B.yy.view(),
          .zz = B.zz.view(),
          .xy = B.xy.view(),
          .xz = B.xz.view(),
          .yz = B.yz.view(),
          .in_xy = in.xy,
          .in_xz = in.xz,
          .in_yz = in.yz,
          .inv_dy = g.inv_dy.data(),
          .inv_dy_face = g.inv_dy_face.data(),
          .dy = g.dy.data(),
          .dy_face = g.dy_face.data(),
          .inv_dx = Real(1 / g.dx),
          .inv_dz = Real(1 / g.dz)};
}

}  // namespace softwall::solid
