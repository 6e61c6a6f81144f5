#pragma once

#include <array>
#include <complex>
#include <vector>

#include "tests/support/linear_algebra.hpp"

/// A small wave v(y) cos(k x) exp(s t) of a viscous fluid at rest under a bonded viscous neo-Hookean layer,
/// both of density 1, between rigid walls at y = 0 and y = depth + thickness. Linear theory: in each layer
///   (D^2 - k^2)(D^2 - m^2) v = 0,  D = d/dy,  m^2 = k^2 + s / N,  N = nu in the fluid, nu_s + G / s in the
///   solid u = -v'/k sin(k x),  p = [N (v''' - k^2 v') - s v'] / k^2 cos(k x),  displacement xi = velocity /
///   s
/// with v = v' = 0 on the walls and v, v', N (v'' + k^2 v), -p + 2 N v' continuous at the interface. The rate
/// s for which such a v exists comes from a table.
namespace softwall {

class InterfaceMode {
 public:
  using Complex = support::Complex;
  struct Layers {
    double depth, thickness, nu_f, nu_s, G, k;
  };

  InterfaceMode(const Layers& layers, Complex s) : l_(layers), s_(s) {
    const Complex zero = 0;
    std::vector<std::vector<Complex>> equations;
    const auto add = [&](const std::array<Complex, 4>& in_fluid, const std::array<Complex, 4>& in_solid) {
      equations.emplace_back(in_fluid.begin(), in_fluid.end());
      equations.back().insert(equations.back().end(), in_solid.begin(), in_solid.end());
    };
    const std::array<Complex, 4> none{zero, zero, zero, zero};
    const double top = l_.depth + l_.thickness;
    for (const int order : {0, 1}) add(basis(false, order, 0), none);
    for (const int order : {0, 1}) add(none, basis(true, order, top));
    for (const int order : {0, 1}) add(basis(false, order, l_.depth), negative(basis(true, order, l_.depth)));
    add(shear_stress(false), negative(shear_stress(true)));
    add(normal_stress(false), negative(normal_stress(true)));
    // Inverse iteration: the null vector of a matrix that is singular but for the digits of s.
    c_.assign(8, Complex(1, 0.5));
    for (int iteration = 0; iteration < 3; ++iteration) {
      c_ = support::solve(equations, c_);
      double size = 0;
      for (const Complex& c : c_) size = std::max(size, std::abs(c));
      for (Complex& c : c_) c /= size;
      amplification_ = size;
    }
  }

  [[nodiscard]] Complex rate() const { return s_; }
  /// Derivative of v of the given order.
  [[nodiscard]] Complex v(double y, int order = 0) const {
    const bool solid = y > l_.depth;
    const auto f = basis(solid, order, y);
    Complex sum = 0;
    for (std::size_t n = 0; n < 4; ++n) sum += c_[n + (solid ? 4 : 0)] * f[n];
    return sum;
  }
  /// How nearly singular the conditions are: large only if s is a rate of these layers.
  [[nodiscard]] double amplification() const { return amplification_; }

 private:
  [[nodiscard]] Complex stiffness(bool solid) const { return solid ? l_.nu_s + l_.G / s_ : Complex(l_.nu_f); }
  /// exp(-k (y - low)), exp(k (y - high)) and the same with m: none is large in its layer.
  [[nodiscard]] std::array<Complex, 4> basis(bool solid, int order, double y) const {
    const double low = solid ? l_.depth : 0, high = solid ? l_.depth + l_.thickness : l_.depth;
    const Complex m = std::sqrt(l_.k * l_.k + s_ / stiffness(solid)), k = l_.k;
    const auto power = [order](Complex q) { return order == 0 ? Complex(1) : std::pow(q, order); };
    return {power(-k) * std::exp(-k * (y - low)), power(k) * std::exp(k * (y - high)),
            power(-m) * std::exp(-m * (y - low)), power(m) * std::exp(m * (y - high))};
  }
  [[nodiscard]] std::array<Complex, 4> shear_stress(bool solid) const {
    const auto v0 = basis(solid, 0, l_.depth), v2 = basis(solid, 2, l_.depth);
    std::array<Complex, 4> out;
    for (std::size_t n = 0; n < 4; ++n) out[n] = stiffness(solid) * (v2[n] + l_.k * l_.k * v0[n]);
    return out;
  }
  [[nodiscard]] std::array<Complex, 4> normal_stress(bool solid) const {
    const auto v1 = basis(solid, 1, l_.depth), v3 = basis(solid, 3, l_.depth);
    const Complex N = stiffness(solid), k2 = l_.k * l_.k;
    std::array<Complex, 4> out;
    for (std::size_t n = 0; n < 4; ++n)
      out[n] = -(N * (v3[n] - k2 * v1[n]) - s_ * v1[n]) / k2 + 2.0 * N * v1[n];
    return out;
  }
  [[nodiscard]] static std::array<Complex, 4> negative(std::array<Complex, 4> f) {
    for (Complex& value : f) value = -value;
    return f;
  }

  Layers l_;
  Complex s_;
  std::vector<Complex> c_;  ///< coefficients of the basis, fluid then solid
  double amplification_ = 0;
};

}  // namespace softwall
