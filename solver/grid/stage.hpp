#pragma once

#include <array>

namespace softwall {

/// One substep of the third-order Runge-Kutta scheme, paper eq:RK:
///   q^k = q^{k-1} + dt (beta R^{k-1} + gamma R^{k-2}) and alpha on each of the old and the new elastic
///   force.
struct Stage {
  double alpha, beta, gamma;
};

inline constexpr std::array<Stage, 3> kRungeKutta3{{
    {4.0 / 15.0, 8.0 / 15.0, 0.0},
    {1.0 / 15.0, 5.0 / 12.0, -17.0 / 60.0},
    {1.0 / 6.0, 3.0 / 4.0, -5.0 / 12.0},
}};

/// Whether a substep is the first, or the last, of the three of a step.
[[nodiscard]] constexpr bool is_first(const Stage& stage) { return stage.gamma == 0; }
[[nodiscard]] constexpr bool is_last(const Stage& stage) { return stage.alpha == kRungeKutta3.back().alpha; }

}  // namespace softwall
