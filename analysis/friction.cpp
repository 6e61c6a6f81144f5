#include "analysis/friction.hpp"

#include <cmath>

namespace softwall::analysis {

Friction friction(const FrictionInput& input) {
  Friction result;
  result.u_tau_w = std::sqrt(input.wall_shear_bottom);
  result.u_tau = std::sqrt(input.driving_gradient * input.interface_y - input.wall_shear_bottom);
  result.re_tau_w = result.u_tau_w * input.reynolds;
  result.re_tau = result.u_tau * input.reynolds;
  return result;
}

}  // namespace softwall::analysis
