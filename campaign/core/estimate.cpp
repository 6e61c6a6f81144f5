#include "campaign/core/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/case/time_comparison.hpp"
#include "solver/case/wall_normal_grid.hpp"

namespace softwall::campaign {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Stability of the scheme (solver/time): advection CFL, explicit diffusion, elastic wave in the smallest
/// cell.
constexpr double kAdvectionLimit = 1.2, kRealAxis = 2.51, kElasticLimit = 0.43;

/// Largest velocities of a turbulent channel at these Reynolds numbers, in U_b, each where its cells are
/// smallest.
constexpr double kU = 1.3, kV = 0.2, kW = 0.2;

/// Largest eigenvalue of B in a softly deforming layer.
constexpr double kStretch = 2.0;

struct Spacing {
  double x, y, z;
};

double smallest_difference(const std::vector<double>& faces, std::size_t first) {
  double smallest = kInfinite;
  for (std::size_t j = first; j + 1 < faces.size(); ++j)
    smallest = std::min(smallest, faces[j + 1] - faces[j]);
  return smallest;
}

double diffusion_limit(const Spacing& d, double viscosity) {
  return kRealAxis / (4.0 * viscosity * (1 / (d.x * d.x) + 1 / (d.y * d.y) + 1 / (d.z * d.z)));
}

}  // namespace

double StepLimits::smallest() const { return std::min({advection, viscosity, elastic}); }

StepLimits step_limits(const Physics& physics) {
  const GridSpec& grid = physics.grid;
  const auto faces = wall_normal_faces(physics);
  const Spacing d{physics.length_x / grid.nx, smallest_difference(faces, 0), physics.length_z / grid.nz};
  const double safety = physics.time_step.safety;
  const double viscosity_ratio = physics.solid ? std::max(1.0, physics.solid->viscosity_ratio) : 1.0;
  StepLimits limits;
  limits.advection = safety * kAdvectionLimit / (kU / d.x + kV / d.y + kW / d.z);
  const bool implicit = physics.time_step.viscosity == ViscousTerms::kImplicit;
  limits.viscosity = implicit ? kInfinite : safety * diffusion_limit(d, viscosity_ratio / physics.reynolds);
  limits.elastic = kInfinite;
  if (physics.solid) {
    const double layer = smallest_difference(faces, static_cast<std::size_t>(grid.ny_fluid));
    const double least = std::min({layer, d.x, d.z});
    limits.elastic = safety * kElasticLimit * least / std::sqrt(physics.solid->G * kStretch);
  }
  return limits;
}

/// A quarter more than was measured with a build for its processor (solver/README.md).
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
