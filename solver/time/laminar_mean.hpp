#pragma once

#include <vector>

#include "solver/time/setup.hpp"

namespace softwall::time {

/// Plane Poiseuille flow of bulk velocity 1 under a layer at rest that its shear stress has deformed. A
/// gradient P drives the whole height, so that the stress is
///   tau(y) = P (1 - y),   nu du/dy = tau in the fluid,   B_xy = d(d_x)/dy = tau / G in the layer,
/// in equilibrium to round-off on the grid itself: differences between neighbouring rows take the place of
/// derivatives, and P is what the grid needs for its sum of u to be that of a bulk velocity of 1. In the
/// continuum P = 3 / Re.
class LaminarMean {
 public:
  explicit LaminarMean(const Setup& setup);

  [[nodiscard]] double gradient() const { return gradient_; }
  /// gamma = tau / G at a height.
  [[nodiscard]] double shear(double y) const { return gradient_ * (1 - y) / G_; }
  /// u at the center of a row, zero in the layer.
  [[nodiscard]] double u(int row) const { return u_[static_cast<std::size_t>(row)]; }
  /// d_x at the center of a row; below the interface it goes on in a straight line.
  [[nodiscard]] double displacement(int row) const { return displacement_[static_cast<std::size_t>(row)]; }

 private:
  double G_, gradient_ = 1;
  std::vector<double> u_, displacement_;
};

}  // namespace softwall::time
