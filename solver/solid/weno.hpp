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
  // In first differences e and second ones s the indicators
  // 13/12 (q0 - 2 q1 + q2)^2 + 1/4 (q0 - 4 q1 + 3 q2)^2, ... are short; c_r = tiny + b_r.
  const Real e1 = q2 - q1, e2 = q3 - q2;
  const Real s0 = e1 - (q1 - q0), s1 = e2 - e1, s2 = (q4 - q3) - e2;
  const Real f1 = kTiny + square(e1), f2 = kTiny + square(e2);
  const Real c0 = f1 + s0 * (e1 + Real(4.0 / 3) * s0);
  const Real c1 = f1 + s1 * (e1 + Real(4.0 / 3) * s1);
  const Real c2 = f2 + s2 * (Real(4.0 / 3) * s2 - e2);
  // Ten times the weights, or that times a common factor.
  Real a0, a1, a2;
  if constexpr (kWeights == WenoWeights::kZ && sizeof(Real) == sizeof(float)) {
    // a_r = d_r (1 + (tau / c_r)^2), tau = |b0 - b2|; one division serves the three. Brought to one
    // denominator, as below, they would be sixth powers of c, too small for this precision.
    const Real scale = (c0 - c2) / (c0 * c1 * c2);
    a0 = 1 + square(scale * (c1 * c2));
    a1 = 6 + 6 * square(scale * (c0 * c2));
    a2 = 3 + 3 * square(scale * (c0 * c1));
  } else {
    // a_r = d_r / c_r^2, or d_r (1 + tau^2 / c_r^2), brought to one denominator.
    const Real w0 = square(c0), w1 = square(c1), w2 = square(c2);
    a0 = w1 * w2;
    a1 = w0 * w2;
    a2 = w0 * w1;
    if constexpr (kWeights == WenoWeights::kZ) {
      const Real all = w0 * a0, tau_squared = square(c0 - c2);
      a0 = all + tau_squared * a0;
      a1 = all + tau_squared * a1;
      a2 = all + tau_squared * a2;
    }
    a1 *= 6;
    a2 *= 3;
  }
  // What the three parabolas add to q2, twice.
  constexpr Real kThird = Real(1.0 / 3);
  const Real p0 = e1 + 2 * kThird * s0, p1 = e1 + 2 * kThird * s1, p2 = e2 - kThird * s2;
  return q2 + (a0 * p0 + a1 * p1 + a2 * p2) / (2 * (a0 + a1 + a2));
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
