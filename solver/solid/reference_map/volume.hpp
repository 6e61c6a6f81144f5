#pragma once

#include <vector>

#include "solver/grid/field.hpp"

/// Keeps the discrete map from changing volume. Transport and extrapolation make small errors of det A, which
/// nothing else would ever undo: the flow has no divergence and the stress knows no volume, so they would add
/// up, and with them the volume of the solid. They are let out through the surface by diffusion,
///   dd_i/dt = u_i - u . grad(d_i) - D_i d/dx_i (det A - 1),
/// which to first order in d is d(det A)/dt = sum_i d/dx_i [ D_i d/dx_i (det A) ]. D_i is U_b times the
/// spacing, the rate at which transport makes them, or what is stable if that is less. Where volume is kept,
/// nothing happens.
///
/// det A - 1 counts in full cells; outside them it is zero. Weighted with phi in partly filled cells instead
/// it drove waves of the surface: what stands there is extrapolated, and its errors go with phi.
namespace softwall::solid::reference_map {

using grid::Grid;
using grid::Real;
using grid::View;

/// D_i / spacing, U_b.
class RelaxationSpeeds {
 public:
  explicit RelaxationSpeeds(const Grid& grid);
  /// For steps of length dt.
  void set(double dt);

  [[nodiscard]] Real x() const { return x_; }
  [[nodiscard]] Real z() const { return z_; }
  /// Across y face j: element j.
  [[nodiscard]] const Real* y() const { return y_.data(); }

 private:
  const Grid& grid_;
  Real x_ = 0, z_ = 0;
  std::vector<Real> y_;
};

/// The last term of the rates, D_i d/dx_i (det A - 1), where the components of d live. phi and det A at
/// centers, with one column more on every side.
struct VolumeRelaxation {
  /// Errors beyond it count as if they were this large: they belong to a map that is torn.
  static constexpr Real kLargestError = 0.5;

  View<const Real> phi, determinant;
  Real speed_x, speed_z;
  const Real* speed_y;

  VolumeRelaxation(const RelaxationSpeeds& speeds, const grid::Field& fraction, const grid::Field& det_A)
      : phi(fraction.view()),
        determinant(det_A.view()),
        speed_x(speeds.x()),
        speed_z(speeds.z()),
        speed_y(speeds.y()) {}

  [[nodiscard]] Real error(int i, int j, int k) const {
    const Real e = determinant(i, j, k) - 1;
    const Real less = e < kLargestError ? e : kLargestError,
               bounded = less > -kLargestError ? less : -kLargestError;
    return phi(i, j, k) < 1 ? Real(0) : bounded;
  }
  [[nodiscard]] Real x(int i, int j, int k) const { return speed_x * (error(i, j, k) - error(i - 1, j, k)); }
  [[nodiscard]] Real y(int i, int j, int k) const {
    return speed_y[j] * (error(i, j, k) - error(i, j - 1, k));
  }
  [[nodiscard]] Real z(int i, int j, int k) const { return speed_z * (error(i, j, k) - error(i, j, k - 1)); }
};

}  // namespace softwall::solid::reference_map
