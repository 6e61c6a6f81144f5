#pragma once

#include "solver/case/case.hpp"

namespace softwall::support {

/// Transported B with the paper's transport of phi: what a test starts from and changes where it wants
/// something else.
inline SolidSpec solid_of(double G) {
  return {.G = G,
          .viscosity_ratio = 1,
          .formulation = SolidFormulation::kTransportedB,
          .weno = WenoWeights::kZ,
          .interface = InterfaceTransport::kWeno,
          .threshold = 0.9,
          .min_eigenvalue = 1e-4,
          .extension = Extension::kColumn,
          .stiffness = Stiffness::kImplicit,
          .dt_plus = 0,
          .disc = std::nullopt};
}

}  // namespace softwall::support
