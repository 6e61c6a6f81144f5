#pragma once

#include "solver/solid/material.hpp"

/// The cofactors C of B where the components of B live, for a stress that needs more of B than the component
/// of its own place (case/elastic_law.hpp). Of the other components the means over the nearest places are
/// taken, those between two rows weighted by the share of the row above.
///
/// The material holds fast to a wall, so that there B_yy = 1, B_xx = 1 + B_xy^2, B_zz = 1 + B_yz^2 and
/// B_xz = B_xy B_yz: hence C_xy = -B_xy and C_yz = -B_yz, and no row beyond a wall is read.
///
/// Reads B one column and plane beyond the place on either side.
namespace softwall::solid {

struct Cofactors {
  View<const Real> Bxx, Byy, Bzz, Bxy, Bxz, Byz;
  const Real* upper_share;  ///< share of row j in the control volume around face j
  int top;                  ///< the face on the upper wall

  Real xx(int i, int j, int k) const {
    const Real yz = (Byz(i, j, k) + Byz(i, j + 1, k) + (Byz(i, j, k + 1) + Byz(i, j + 1, k + 1))) / 4;
    return Byy(i, j, k) * Bzz(i, j, k) - yz * yz;
  }
  Real yy(int i, int j, int k) const {
    const Real xz = (Bxz(i, j, k) + Bxz(i + 1, j, k + 1) + (Bxz(i + 1, j, k) + Bxz(i, j, k + 1))) / 4;
    return Bxx(i, j, k) * Bzz(i, j, k) - xz * xz;
  }
  Real zz(int i, int j, int k) const {
    const Real xy = (Bxy(i, j, k) + Bxy(i, j + 1, k) + (Bxy(i + 1, j, k) + Bxy(i + 1, j + 1, k))) / 4;
    return Bxx(i, j, k) * Byy(i, j, k) - xy * xy;
  }
  Real xy(int i, int j, int k) const {
    if (is_wall(j)) return -Bxy(i, j, k);
    const Real yz = (Byz(i, j, k) + Byz(i - 1, j, k) + (Byz(i, j, k + 1) + Byz(i - 1, j, k + 1))) / 4;
    const Real xz = between(j, [=, this](int row) { return Bxz(i, row, k) + Bxz(i, row, k + 1); });
    const Real zz = between(j, [=, this](int row) { return Bzz(i, row, k) + Bzz(i - 1, row, k); });
    return xz * yz - Bxy(i, j, k) * zz;
  }
  Real yz(int i, int j, int k) const {
    if (is_wall(j)) return -Byz(i, j, k);
    const Real xy = (Bxy(i, j, k) + Bxy(i, j, k - 1) + (Bxy(i + 1, j, k) + Bxy(i + 1, j, k - 1))) / 4;
    const Real xz = between(j, [=, this](int row) { return Bxz(i, row, k) + Bxz(i + 1, row, k); });
    const Real xx = between(j, [=, this](int row) { return Bxx(i, row, k) + Bxx(i, row, k - 1); });
    return xy * xz - Byz(i, j, k) * xx;
  }
  Real xz(int i, int j, int k) const {
    const Real xy = (Bxy(i, j, k) + Bxy(i, j + 1, k) + (Bxy(i, j, k - 1) + Bxy(i, j + 1, k - 1))) / 4;
    const Real yz = (Byz(i, j, k) + Byz(i, j + 1, k) + (Byz(i - 1, j, k) + Byz(i - 1, j + 1, k))) / 4;
    const Real yy = (Byy(i, j, k) + Byy(i - 1, j, k - 1) + (Byy(i - 1, j, k) + Byy(i, j, k - 1))) / 4;
    return xy * yz - Bxz(i, j, k) * yy;
  }
  /// C_xz at a center.
  Real xz_of_center(int i, int j, int k) const {
    const Real xy = (Bxy(i, j, k) + Bxy(i, j + 1, k) + (Bxy(i + 1, j, k) + Bxy(i + 1, j + 1, k))) / 4;
    const Real yz = (Byz(i, j, k) + Byz(i, j + 1, k) + (Byz(i, j, k + 1) + Byz(i, j + 1, k + 1))) / 4;
    const Real xz = (Bxz(i, j, k) + Bxz(i + 1, j, k + 1) + (Bxz(i + 1, j, k) + Bxz(i, j, k + 1))) / 4;
    return xy * yz - xz * Byy(i, j, k);
  }

 private:
  [[nodiscard]] bool is_wall(int j) const { return j == 0 || j == top; }
  /// Half of what two neighbours add up to, between the rows that meet at face j.
  template <class InRow>
  [[nodiscard]] Real between(int j, const InRow& sum) const {
    const Real below = sum(j - 1);
    return (below + upper_share[j] * (sum(j) - below)) / 2;
  }
};

[[nodiscard]] inline Cofactors cofactors_of(const Material& m, const Grid& g) {
  return {.Bxx = m.B.xx.view(),
          .Byy = m.B.yy.view(),
          .Bzz = m.B.zz.view(),
          .Bxy = m.B.xy.view(),
          .Bxz = m.B.xz.view(),
          .Byz = m.B.yz.view(),
          .upper_share = g.upper_share.data(),
          .top = g.ny};
}

}  // namespace softwall::solid
