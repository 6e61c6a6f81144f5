#pragma once

#include "solver/case/case.hpp"
#include "solver/grid/field.hpp"

/// Fifth-order WENO value on the face between two cells, from five values of which q2 is the upwind cell.
/// Smoothness indicators and linear weights: Jiang & Shu, J. Comput. Phys. 126 (1996); Z weights: Borges,
/// Carmona, Costa & Don, J. Comput. Phys. 227 (2008). All six values around the face are loaded and the
/// upwind five selected by blending, without branches, so that the compiler can vectorize.
namespace softwall::solid {

using grid::Real;

template <WenoWeights kWeights>
inline Real weno5(Real q0, Real q1, Real q2, Real q3, Real q4) {
  // The papers' values; 1e-20 where its square, and what is divided by it, are numbers that Real can hold.
  constexpr Real kTinyZ = sizeof(Real) == sizeof(float) ? 1e-8 : 1e-20;
  constexpr Real kTiny = kWeights == WenoWeights::kJiangShu ? Real(1e-6) : kTinyZ;
  const auto square = [](Real x) { return x * x; };
  const Real b0 = Real(13.0 / 12) * square(q0 - 2 * q1 + q2) + Real(0.25) * square(q0 - 4 * q1 + 3 * q2);
  const Real b1 = Real(13.0 / 12) * square(q1 - 2 * q2 + q3) + Real(0.25) * square(q1 - q3);
  const Real b2 = Real(13.0 / 12) * square(q2 - 2 * q3 + q4) + Real(0.25) * square(3 * q2 - 4 * q3 + q4);
  Real a0, a1, a2;
  if constexpr (kWeights == WenoWeights::kJiangShu) {
    // a_r = d_r / (tiny + b_r)^2, brought to one denominator.
    const Real s0 = square(kTiny + b0), s1 = square(kTiny + b1), s2 = square(kTiny + b2);
    a0 = Real(0.1) * s1 * s2;
    a1 = Real(0.6) * s0 * s2;
    a2 = Real(0.3) * s0 * s1;
  } else {
    // a_r = d_r (1 + (tau / c_r)^2), tau = |b0 - b2|, c_r = tiny + b_r; one division serves the three.
    const Real c0 = kTiny + b0, c1 = kTiny + b1, c2 = kTiny + b2;
    const Real scale = (b0 - b2) / (c0 * c1 * c2);
    a0 = Real(0.1) * (1 + square(scale * (c1 * c2)));
    a1 = Real(0.6) * (1 + square(scale * (c0 * c2)));
    a2 = Real(0.3) * (1 + square(scale * (c0 * c1)));
  }
  const Real p0 = 2 * q0 - 7 * q1 + 11 * q2, p1 = -q1 + 5 * q2 + 2 * q3, p2 = 2 * q2 + 5 * q3 - q4;
  return (a0 * p0 + a1 * p1 + a2 * p2) / (6 * (a0 + a1 + a2));
}

/// Flux `velocity * q` through the face between the cells at `q[-stride]` and `q[0]`.
template <WenoWeights kWeights>
inline Real upwind_flux(const Real* q, std::ptrdiff_t stride, Real velocity) {
  const bool forward = velocity > 0;
  const Real m3 = q[-3 * stride], m2 = q[-2 * stride], m1 = q[-stride], p0 = q[0], p1 = q[stride],
             p2 = q[2 * stride];
  return velocity * weno5<kWeights>(forward ? m3 : p2, forward ? m2 : p1, forward ? m1 : p0,
                                    forward ? p0 : m1, forward ? p1 : m2);
}

}  // namespace softwall::solid
