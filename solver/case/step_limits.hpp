#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "solver/case/case.hpp"
#include "solver/case/elastic_law.hpp"

/// Largest stable time steps of the scheme, as pure functions of rates and stiffnesses: the solver evaluates
/// them for its state, the manager for what it expects of a case.
namespace softwall::step_limits {

/// How far the three Runge-Kutta substeps are stable along the imaginary axis (central convection) and along
/// the negative real one (viscosity).
inline constexpr double kImaginaryAxis = std::numbers::sqrt3, kRealAxis = 2.51;

/// rate: the largest |u|/dx + |v|/dy + |w|/dz.
[[nodiscard]] inline double convection(double rate) {
  return rate > 0 ? kImaginaryAxis / rate : std::numeric_limits<double>::infinity();
}

/// rate: 1/dx^2 + 1/dy^2 + 1/dz^2, each times its viscosity over `viscosity`.
[[nodiscard]] inline double viscosity(double viscosity, double rate) {
  return kRealAxis / (4 * viscosity * rate);
}

/// What is accurate, where stability would allow more: dt_plus viscous times nu / u_tau^2, u_tau^2 being
/// driving_gradient times h. Infinite for dt_plus = 0, and where nothing drives the flow.
[[nodiscard]] inline double accuracy(double dt_plus, double viscosity, double driving_gradient) {
  return dt_plus > 0 && driving_gradient > 0 ? dt_plus * viscosity / driving_gradient
                                             : std::numeric_limits<double>::infinity();
}

/// B of a cell, or what is expected of it; positive definite.
template <class Real>
struct Deformation {
  Real xx, yy, zz, xy, xz, yz;
};

template <class Real>
struct InverseSpacings {
  Real dx, dy, dz;
};

/// sum_ij |B_ij| / (d_i d_j): the law's stiffness of it is omega^2 / 4 of the stiffest two-cell wave of a
/// cell.
template <class Real>
[[nodiscard]] inline Real stiffness(const Deformation<Real>& B, const InverseSpacings<Real>& inv) {
  return B.xx * inv.dx * inv.dx + B.yy * inv.dy * inv.dy + B.zz * inv.dz * inv.dz +
         2 * (std::abs(B.xy) * inv.dx * inv.dy + std::abs(B.xz) * inv.dx * inv.dz +
              std::abs(B.yz) * inv.dy * inv.dz);
}

/// Share of the implicit stress between rows that is added to it (solid/row_stiffness.hpp), so as to outweigh
/// what is explicit of waves that run obliquely.
inline constexpr double kSpareStiffness = 0.25;

/// The stiffness of what stays explicit when the stress between rows is implicit. A wave of frequency w_y
/// through y, w_a along the rows and 2 w_y q of B_xy and B_yz is stable while
///   w_a^2 + 2 w_y q + w_y^2 < 4 / dt^2 + (1 + s) w_y^2,   s = kSpareStiffness,
/// for every w_y, if w_a^2 + q^2 / s < 4 / dt^2. Of a positive definite B, q^2 is at most twice w_a^2; that
/// of a torn map (solid/reference_map/mending.hpp) may be anything and must not stop the run.
template <class Real>
[[nodiscard]] inline Real stiffness_along_rows(const Deformation<Real>& B, const InverseSpacings<Real>& inv) {
  const Real oblique = std::abs(B.xy) * inv.dx + std::abs(B.yz) * inv.dz,
             along = B.xx * inv.dx * inv.dx + B.zz * inv.dz * inv.dz, most = 2 * B.yy * along;
  const Real square = oblique * oblique < most ? oblique * oblique : most;
  return along + 2 * std::abs(B.xz) * inv.dx * inv.dz + square / (Real(kSpareStiffness) * B.yy);
}

/// stiffest: the largest stiffness of a cell, of the kind that the integration leaves explicit. Explicit
/// waves grow visibly beyond omega dt = 0.86. With one elastic force a step, that of its middle, they are
/// neutral as far as 2; the advection of the displacement takes some of that.
[[nodiscard]] inline double elastic(Stiffness integration, const ElasticLaw<double>& law, double stiffest) {
  constexpr double kExplicit = 0.86, kImplicit = 1.7;
  const double omega = 2 * std::sqrt(law.stiffness(stiffest));
  if (!(omega > 0)) return std::numeric_limits<double>::infinity();
  return (integration == Stiffness::kImplicit ? kImplicit : kExplicit) / omega;
}

}  // namespace softwall::step_limits
