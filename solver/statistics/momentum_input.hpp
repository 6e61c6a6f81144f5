#pragma once

#include <optional>

#include "solver/fluid/momentum.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::statistics {

/// What the kernels of the momentum equation read at this moment, with another viscosity if given.
[[nodiscard]] inline fluid::MomentumInput momentum_input(const time::State& s, const time::Setup& setup,
                                                         std::optional<double> viscosity = std::nullopt) {
  const grid::Grid& g = setup.grid;
  return {s.velocity.x.view(),  s.velocity.y.view(),  s.velocity.z.view(),
          g.inv_dy.data(),      g.inv_dy_face.data(), g.upper_share.data(),
          grid::Real(1 / g.dx), grid::Real(1 / g.dz), grid::Real(viscosity.value_or(setup.viscosity))};
}

}  // namespace softwall::statistics
