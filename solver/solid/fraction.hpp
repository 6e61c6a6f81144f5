#pragma once

#include <algorithm>

#include "solver/solid/interface_share.hpp"
#include "solver/solid/material.hpp"

/// Solid fraction at centers and on the edges where shear stress lives: there, that of the control volume
/// from the center below to the center above, a mean over the two columns (planes) that meet. Where phi
/// smears over several cells, a volume-weighted mean of cells is all there is to say. Where it is the share
/// of a cell above a surface, the solid of a cell lies in its upper part, and so in the volume of the edge
/// above it first:
///   (1 - s) min(phi_below, 1/2) + s max(phi_above - 1/2, 0), times 2; s: share of the cell above.
/// Then a surface that moves within half a cell changes phi on the one edge that it is on. With the mean of
/// cells it changed the stress of an edge of fluid, or of solid, beside it by as much as its displacement
/// over the spacing, which no refinement made smaller: of waves too small to leave a cell (2-D, G = 0.25,
/// wave length 2, laminar) the growth rate came out 0.0712, 0.0715 and 0.0726 on 48 x 128, 96 x 128 and 192 x
/// 256 cells, where linear theory has 0.0756; with this 0.0763, 0.0766 and 0.0758.
namespace softwall::solid {

struct Fraction {
  View<const Real> phi;
  const Real* upper_share;  ///< share of row j in the control volume around face j
  bool is_sharp = false;    ///< whether phi is the share of a cell above a surface

  Real center(int i, int j, int k) const { return phi(i, j, k); }
  [[gnu::always_inline]] Real edge_xy(int i, int j, int k) const {
    return over_face(j, phi(i, j, k), phi(i, j - 1, k)) +
           over_face(j, phi(i - 1, j, k), phi(i - 1, j - 1, k));
  }
  [[gnu::always_inline]] Real edge_xz(int i, int j, int k) const {
    return (phi(i, j, k) + phi(i - 1, j, k) + phi(i, j, k - 1) + phi(i - 1, j, k - 1)) / 4;
  }
  [[gnu::always_inline]] Real edge_yz(int i, int j, int k) const {
    return over_face(j, phi(i, j, k), phi(i, j - 1, k)) +
           over_face(j, phi(i, j, k - 1), phi(i, j - 1, k - 1));
  }

 private:
  /// Half the fraction around face j, from the cells above and below.
  [[gnu::always_inline]] Real over_face(int j, Real above, Real below) const {
    constexpr Real kHalf = 0.5;
    const Real in_lower_half = std::max(above - kHalf, Real(0)), in_upper_half = std::min(below, kHalf);
    const Real of_above = is_sharp ? in_lower_half : above / 2,
               of_below = is_sharp ? in_upper_half : below / 2;
    return upper_share[j] * of_above + (1 - upper_share[j]) * of_below;
  }
};

/// As the material's interface is: sharp where stress is not shared by volume.
[[nodiscard]] inline Fraction fraction_of(const Material& m, const InterfaceShare& share, const Grid& g) {
  return {m.phi.view(), g.upper_share.data(), !share.is_mean_by_volume()};
}

}  // namespace softwall::solid
