#pragma once

#include "solver/case/case.hpp"

/// What a case would cost, before it has run: for `softwall plan` and for the first ETA.
namespace softwall::campaign {

/// The step limits at typical turbulent velocities, h/U_b, those of stability with the safety factor;
/// infinite where there is none. The smallest binds.
struct StepLimits {
  double convection = 0.0, viscosity = 0.0, elastic = 0.0, accuracy = 0.0;
  [[nodiscard]] double smallest() const;
};
[[nodiscard]] StepLimits step_limits(const Physics& physics);

struct Estimate {
  double dt = 0.0;     ///< h/U_b
  double steps = 0.0;  ///< to the end time
  double cells = 0.0;
  double core_hours = 0.0;
};

/// Core-nanoseconds per cell and step of a case when nothing has been measured on this machine.
[[nodiscard]] double default_ns_per_cell_step(const Physics& physics);

/// From time `reached` to the end time. ns_per_cell_step: core-nanoseconds (wall clock times ranks) per cell
/// and step.
[[nodiscard]] Estimate estimate(const Case& c, double ns_per_cell_step, double reached = 0.0);

}  // namespace softwall::campaign
