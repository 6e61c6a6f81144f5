#pragma once

#include <algorithm>
#include <vector>

#include "solver/grid/field.hpp"

/// How fluid and solid share the shear stress of an edge that the interface cuts. Both sides bear the same
/// stress, so that any mean of the two is right,
///   tau = (1 - s) mu_f g_f + s (mu_s g_s + G B),   g_f = (g - phi g_s) / (1 - phi),
/// with g the velocity's difference across the edge, and g_s and B the solid's own shear and deformation. But
/// these two stand a row above, where the stress is another by a spacing times the gradient of pressure; g_f
/// stands where it is needed. With the mean by volume, s = phi, a layer that hardly yields (G = 8, 32 x 32 +
/// 8 x 32 cells) had a Re_tau 6 % below that of the rigid wall opposite, and w' in the first row of cells
/// was a third too low; with the fluid's stress alone at a flat interface both are as at the rigid wall,
///   s = max(0, phi - a) / (1 - a),   a = (1/2) / (1 + r^2).
/// All that supposes that the fluid lies below the edge and the solid above. Where the interface rises by as
/// much as a row from one column to the next (r = 1) they lie side by side as well, and s must return to phi:
/// with a = 1/2 everywhere the waves of a soft layer (G = 0.25, 32 x 32 + 8 x 32 and 48 x 48 + 12 x 48 cells)
/// grew until they broke.
namespace softwall::solid {

using grid::Grid;
using grid::Real;

/// s at an edge of which the share `phi` is solid.
inline Real share_of_solid(Real phi, Real a) { return std::max(Real(0), phi - a) / (1 - a); }
/// (1 - s) / (1 - phi), the factor of mu_f (g - phi g_s): at most 1 / (1 - a).
inline Real factor_of_fluid(Real phi, Real a) { return 1 / (1 - std::min(phi, a)); }

/// a on the edges of an interface, for kernels.
struct InterfaceShareView {
  const Real* over_columns;
  std::ptrdiff_t stride;
  Real xy(int i, int k) const {
    const Real* const a = over_columns + k * stride;
    return (a[i - 1] + a[i]) / 2;
  }
  Real yz(int i, int k) const {
    const Real* const a = over_columns + k * stride;
    return (a[i - stride] + a[i]) / 2;
  }
};

/// a over this rank's columns and one more on every side.
class InterfaceShare {
 public:
  /// `flat`: a where the interface lies flat, as it does everywhere at first; 0: the mean by volume.
  InterfaceShare(Real flat, const Grid& grid)
      : flat_(flat),
        stride_(grid.nx + 2),
        nz_(grid.nz),
        over_columns_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(grid.nz + 2), flat) {}

  /// flatness(i, k): 1 / (1 + r^2) over a column.
  template <class Flatness>
  void follow(const Flatness& flatness) {
    for (int k = -1; k <= nz_; ++k) {
      Real* const a = over_columns_.data() + offset(k);
      for (int i = -1; i < stride_ - 1; ++i) a[i] = flat_ * Real(flatness(i, k));
    }
  }

  [[nodiscard]] InterfaceShareView view() const { return {over_columns_.data() + offset(0), stride_}; }
  [[nodiscard]] bool is_mean_by_volume() const { return flat_ == 0; }
  /// The largest that the factor of the fluid can be.
  [[nodiscard]] Real largest_factor() const { return factor_of_fluid(1, flat_); }

 private:
  [[nodiscard]] std::ptrdiff_t offset(int k) const { return (k + 1) * stride_ + 1; }

  Real flat_;
  std::ptrdiff_t stride_;
  int nz_;
  std::vector<Real> over_columns_;
};

inline constexpr Real kMeanByVolume = 0;
/// An edge on a flat interface is what it is on the wall of a channel: viscosity times the velocity half a
/// cell below it, over half a cell.
inline constexpr Real kFluidAtFlatInterface = 0.5;

}  // namespace softwall::solid
