#include "campaign/core/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/case/step_limits.hpp"
#include "solver/case/time_comparison.hpp"
#include "solver/case/wall_normal_grid.hpp"

namespace softwall::campaign {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Largest velocities of a turbulent channel at these Reynolds numbers, in U_b, each where its cells are
/// smallest.
constexpr double kU = 1.3, kV = 0.2, kW = 0.2;

/// Largest eigenvalue of B in a layer that waves deform: near 1 in a stiff one, 2 at G = 0.5, and in a softer
/// one more.
double stretch(double G) { return 1 + 0.5 / G; }

struct Spacing {
  double x, y, z;
};

double smallest_difference(const std::vector<double>& faces, std::size_t first) {
  double smallest = kInfinite;
  for (std::size_t j = first; j + 1 < faces.size(); ++j)
    smallest = std::min(smallest, faces[j + 1] - faces[j]);
  return smallest;
}

/// The viscosities of what is explicit over the fluid's: along the rows and between them.
struct Viscosities {
  double along = 1, across = 1;
};

Viscosities viscosities(const Physics& physics) {
  if (!physics.solid) return {};
  const double larger = std::max(1.0, physics.solid->viscosity_ratio);
  return {larger, physics.solid->stiffness == Stiffness::kImplicit ? 1.0 : larger};
}

double diffusion_limit(const Spacing& d, const Physics& physics) {
  const auto [along, across] = viscosities(physics);
  return step_limits::viscosity(1 / physics.reynolds,
                                along / (d.x * d.x) + across / (d.y * d.y) + along / (d.z * d.z));
}

double elastic_limit(const Spacing& d, const SolidSpec& solid) {
  const double most = stretch(solid.G);
  const step_limits::Deformation<double> B{most, most, most, 0, 0, 0};
  const step_limits::InverseSpacings<double> inv{1 / d.x, 1 / d.y, 1 / d.z};
  return step_limits::elastic(
      solid.stiffness, {solid.G},
      solid.stiffness == Stiffness::kImplicit ? stiffness_along_rows(B, inv) : stiffness(B, inv));
}

/// Of a rigid channel Re_tau = 0.09 (2 Re)^0.88 (Pope 2000, section 7.1.5); waves on a soft layer add to it.
double driving_gradient(const Physics& physics) {
  const double u_tau = 0.09 * std::pow(2 * physics.reynolds, 0.88) / physics.reynolds;
  return u_tau * u_tau * (1 + 0.15 / physics.solid->G);
}

}  // namespace

double StepLimits::smallest() const { return std::min({convection, viscosity, elastic, accuracy}); }

StepLimits step_limits(const Physics& physics) {
  const GridSpec& grid = physics.grid;
  const auto faces = wall_normal_faces(physics);
  const Spacing d{physics.length_x / grid.nx, smallest_difference(faces, 0), physics.length_z / grid.nz};
  const double safety = physics.time_step.safety;
  StepLimits limits;
  limits.convection = safety * step_limits::convection(kU / d.x + kV / d.y + kW / d.z);
  const bool implicit = physics.time_step.viscosity == ViscousTerms::kImplicit;
  limits.viscosity = implicit ? kInfinite : safety * diffusion_limit(d, physics);
  limits.elastic = limits.accuracy = kInfinite;
  if (physics.solid) {
    const double layer = smallest_difference(faces, static_cast<std::size_t>(grid.ny_fluid));
    limits.elastic = safety * elastic_limit({d.x, layer, d.z}, *physics.solid);
    if (is_driven_channel(physics.flow))
      limits.accuracy =
          step_limits::accuracy(physics.solid->dt_plus, 1 / physics.reynolds, driving_gradient(physics));
  }
  return limits;
}

/// A quarter more than was measured with a build for its processor (solver/PERFORMANCE.md).
double default_ns_per_cell_step(const Physics& physics) {
  constexpr double kFluid = 100, kReferenceMap = 160, kTransportedB = 260;
  const auto with_solid = [](const SolidSpec& solid) {
    return solid.formulation == SolidFormulation::kReferenceMap ? kReferenceMap : kTransportedB;
  };
  const double in_double = physics.solid ? with_solid(*physics.solid) : kFluid;
  return physics.precision == Precision::kSingle ? in_double / 2 : in_double;
}

Estimate estimate(const Case& c, double ns_per_cell_step, double reached) {
  constexpr double kNanosecondsPerHour = 3.6e12;
  const GridSpec& grid = c.physics.grid;
  Estimate result;
  result.dt = c.physics.time_step.fixed_dt.value_or(step_limits(c.physics).smallest());
  // Ten steps of 0.1 make 1, although 1 / 0.1 need not be 10 exactly.
  const double left = has_reached(reached, c.run.end_time) ? 0.0 : c.run.end_time - reached;
  result.steps = std::ceil(left / result.dt * (1 - kTimeRoundOff));
  result.cells = static_cast<double>(grid.nx) * grid.ny() * grid.nz;
  result.core_hours = result.steps * result.cells * ns_per_cell_step / kNanosecondsPerHour;
  return result;
}

}  // namespace softwall::campaign
