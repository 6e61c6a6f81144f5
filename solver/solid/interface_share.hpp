#pragma once

#include <algorithm>

#include "solver/grid/field.hpp"

/// How fluid and solid share the shear stress of an edge that the interface cuts. Both sides bear the same
/// stress, so that any mean of the two is right,
///   tau = (1 - s) mu_f g_f + s (mu_s g_s + G B),   g_f = (g - phi g_s) / (1 - phi),
/// with g the velocity's difference across the edge, and g_s and B the solid's own shear and deformation. But
/// these two stand a row above, where the stress is another by a spacing times the gradient of pressure; g_f
/// stands where it is needed. With the mean by volume, s = phi, a layer that hardly yields (G = 8, 32 x 32 +
/// 8 x 32 cells) had a Re_tau 6 % below that of the rigid wall opposite, and w' in the first row of cells
/// was a third too low; with the fluid's stress alone at a flat interface both are as at the rigid wall.
namespace softwall::solid {

using grid::Real;

class InterfaceShare {
 public:
  /// fluid_alone: phi up to which the fluid's stress counts alone; beyond, it gives way linearly.
  explicit constexpr InterfaceShare(Real fluid_alone)
      : fluid_alone_(fluid_alone), slope_(1 / (1 - fluid_alone)) {}

  /// s
  [[nodiscard]] Real solid(Real phi) const { return std::max(Real(0), phi - fluid_alone_) * slope_; }
  /// (1 - s) / (1 - phi), the factor of mu_f (g - phi g_s): at most 1 / (1 - fluid_alone).
  [[nodiscard]] Real fluid(Real phi) const { return 1 / (1 - std::min(phi, fluid_alone_)); }
  [[nodiscard]] constexpr bool is_mean_by_volume() const { return fluid_alone_ == 0; }

 private:
  Real fluid_alone_, slope_;
};

/// s = phi.
inline constexpr InterfaceShare kMeanByVolume{0};
/// An edge on a flat interface is what it is on the wall of a channel: viscosity times the velocity half a
/// cell below it, over half a cell.
inline constexpr InterfaceShare kFluidAtInterface{Real(0.5)};

}  // namespace softwall::solid
