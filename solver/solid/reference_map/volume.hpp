#pragma once

#include <vector>

#include "solver/grid/field.hpp"

/// Keeps the discrete map from changing volume. Transport and extrapolation make small errors of det A, which
/// nothing else would ever undo: the flow has no divergence and the stress knows no volume, so they would add
/// up, and with them the volume of the solid. They are let out through the surface by diffusion,
///   dd_i/dt = u_i - u . grad(d_i) - K_i d/dx_i (det A - 1),
/// which to first order in d is d(det A)/dt = sum_i d/dx_i [ K_i d/dx_i (det A) ]. K_i is U_b times the
/// spacing, the rate at which transport makes them, or what is stable if that is less. Where volume is kept,
/// nothing happens. In a solid with slopes beyond 2 sqrt(K_y / K_x) it is no longer dissipative in all
/// directions.
///
/// det A - 1 counts in full cells; outside them it is zero. Weighted with phi in partly filled cells instead
/// it drove waves of the surface: what stands there is extrapolated, and its errors go with phi.
///
/// That diffusion cannot restore the volume of the whole solid, which transport changes, too, by 0.1 % in a
/// unit of time where waves are steep, and by 2 % where they break. So the layer as a whole is stretched or
/// compressed evenly, in proportion to the change but by no more than 10 % in a unit of time
/// (RelaxationSpeeds::restore_volume): where the surface folds, its mean height, which measures the volume
/// here, changes faster, and rightly so. A limit of 1 % let a layer of G = 0.125 lose 3 % of its volume.
namespace softwall::solid::reference_map {

using grid::Grid;
using grid::Real;
using grid::View;

/// K_i / spacing, and the speed at which the whole layer is stretched; U_b.
class RelaxationSpeeds {
 public:
  explicit RelaxationSpeeds(const Grid& grid);
  /// For steps of length dt.
  void set(double dt);
  /// `excess`: mean height of the surface less its height at rest; both h.
  void restore_volume(double dt, double at_rest, double excess);

  [[nodiscard]] Real x() const { return x_; }
  [[nodiscard]] Real z() const { return z_; }
  /// Across y face j: element j.
  [[nodiscard]] const Real* y() const { return y_.data(); }
  /// Speed of the even stretching of the layer at y face j: element j.
  [[nodiscard]] const Real* even() const { return even_.data(); }

 private:
  const Grid& grid_;
  Real x_ = 0, z_ = 0;
  std::vector<Real> y_, even_;
};

/// Errors beyond it count as if they were this large: they belong to a map that is torn.
inline constexpr Real kLargestVolumeError = 0.5;

/// det A - 1 of a cell as far as it counts.
[[gnu::always_inline]] inline Real volume_error(Real phi, Real determinant) {
  const Real e = determinant - 1;
  const Real less = e < kLargestVolumeError ? e : kLargestVolumeError,
             bounded = less > -kLargestVolumeError ? less : -kLargestVolumeError;
  return phi < 1 ? Real(0) : bounded;
}

/// The last term of the rates, K_i d/dx_i (det A - 1), where the components of d live. error: volume_error at
/// centers, with one column more on every side.
struct VolumeRelaxation {
  View<const Real> error;
  Real speed_x, speed_z;
  const Real *speed_y, *even;

  VolumeRelaxation(const RelaxationSpeeds& speeds, const grid::Field& volume_error)
      : error(volume_error.view()),
        speed_x(speeds.x()),
        speed_z(speeds.z()),
        speed_y(speeds.y()),
        even(speeds.even()) {}

  [[nodiscard]] Real x(int i, int j, int k) const { return speed_x * (error(i, j, k) - error(i - 1, j, k)); }
  [[nodiscard]] Real y(int i, int j, int k) const {
    return speed_y[j] * (error(i, j, k) - error(i, j - 1, k)) + even[j];
  }
  [[nodiscard]] Real z(int i, int j, int k) const { return speed_z * (error(i, j, k) - error(i, j, k - 1)); }
};

}  // namespace softwall::solid::reference_map
