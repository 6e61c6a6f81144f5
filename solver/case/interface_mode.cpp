#include "solver/case/interface_mode.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "solver/case/linear_equations.hpp"

namespace softwall {

namespace {

using Complex = InterfaceMode::Complex;
using Four = std::array<Complex, 4>;  ///< one number for each solution of a layer

/// The solutions of both layers for one rate.
class Solutions {
 public:
  Solutions(const WaveLayers& layers, Complex s) : l_(layers), s_(s) {}

  /// exp(-k (y - low)), exp(k (y - high)) and the same with m, or their derivatives: none is large in its
  /// layer.
  [[nodiscard]] Four at(bool solid, int order, double y) const {
    const double low = solid ? l_.depth : 0, high = solid ? l_.depth + l_.thickness : l_.depth;
    const Complex m = std::sqrt(l_.k * l_.k + s_ / stiffness(solid)), k = l_.k;
    const auto power = [order](Complex q) { return order == 0 ? Complex(1) : std::pow(q, order); };
    return {power(-k) * std::exp(-k * (y - low)), power(k) * std::exp(k * (y - high)),
            power(-m) * std::exp(-m * (y - low)), power(m) * std::exp(m * (y - high))};
  }

  /// The eight conditions, each a row of eight.
  [[nodiscard]] std::vector<std::vector<Complex>> conditions() const {
    std::vector<std::vector<Complex>> rows;
    const auto add = [&rows](const Four& in_fluid, const Four& in_solid) {
      rows.emplace_back(in_fluid.begin(), in_fluid.end());
      for (const Complex& value : in_solid) rows.back().push_back(-value);
    };
    for (const int order : {0, 1}) add(at(false, order, 0), {});
    for (const int order : {0, 1}) add({}, at(true, order, l_.depth + l_.thickness));
    for (const int order : {0, 1}) add(at(false, order, l_.depth), at(true, order, l_.depth));
    add(shear_stress(false), shear_stress(true));
    add(normal_stress(false), normal_stress(true));
    return rows;
  }

 private:
  [[nodiscard]] Complex stiffness(bool solid) const { return solid ? l_.nu_s + l_.G / s_ : Complex(l_.nu_f); }

  [[nodiscard]] Four shear_stress(bool solid) const {
    const Four v = at(solid, 0, l_.depth), v2 = at(solid, 2, l_.depth);
    Four stress;
    for (std::size_t n = 0; n < 4; ++n) stress[n] = stiffness(solid) * (v2[n] + l_.k * l_.k * v[n]);
    return stress;
  }

  [[nodiscard]] Four normal_stress(bool solid) const {
    const Four v1 = at(solid, 1, l_.depth), v3 = at(solid, 3, l_.depth);
    const Complex N = stiffness(solid), k2 = l_.k * l_.k;
    Four stress;
    for (std::size_t n = 0; n < 4; ++n)
      stress[n] = -(N * (v3[n] - k2 * v1[n]) - s_ * v1[n]) / k2 + 2.0 * N * v1[n];
    return stress;
  }

  WaveLayers l_;
  Complex s_;
};

/// To start from; that it is orthogonal to what is looked for would be a strange coincidence.
std::vector<Complex> some_vector() { return std::vector<Complex>(8, Complex(1, 0.5)); }

/// 1 / sum(A^-1 b): analytic in s, and zero where the conditions A are singular.
Complex singularity(const WaveLayers& layers, Complex s) {
  Complex sum = 0;
  for (const Complex& x : solve(Solutions(layers, s).conditions(), some_vector())) sum += x;
  return 1.0 / sum;
}

bool is_finite(Complex z) { return std::isfinite(z.real()) && std::isfinite(z.imag()); }

}  // namespace

WaveLayers wave_layers(double reynolds, double length_x, double layer_height, double G,
                       double viscosity_ratio) {
  return {.depth = 2,
          .thickness = layer_height,
          .nu_f = 1 / reynolds,
          .nu_s = viscosity_ratio / reynolds,
          .G = G,
          .k = 2 * std::numbers::pi / length_x};
}

/// Finds by inverse iteration the null vector of a matrix that would be singular if s had all its digits.
InterfaceMode::InterfaceMode(const WaveLayers& layers, Complex s)
    : layers_(layers), s_(s), c_(some_vector()) {
  const auto conditions = Solutions(layers, s).conditions();
  for (int iteration = 0; iteration < 3; ++iteration) {
    c_ = solve(conditions, c_);
    double size = 0;
    for (const Complex& c : c_) size = std::max(size, std::abs(c));
    for (Complex& c : c_) c /= size;
  }
}

InterfaceMode::Complex InterfaceMode::v(double y, int order) const {
  const bool solid = y > layers_.depth;
  const Four f = Solutions(layers_, s_).at(solid, order, y);
  Complex sum = 0;
  for (std::size_t n = 0; n < 4; ++n) sum += c_[n + (solid ? 4 : 0)] * f[n];
  return sum;
}

std::optional<InterfaceMode::Complex> nearest_rate(const WaveLayers& layers, Complex guess) {
  constexpr int kMostSteps = 50;
  constexpr double kConverged = 1e-11;
  try {
    Complex before = guess * (1 + 1e-4), now = guess, f_before = singularity(layers, before);
    for (int step = 0; step < kMostSteps; ++step) {
      const Complex f_now = singularity(layers, now),
                    next = now - f_now * (now - before) / (f_now - f_before);
      if (!is_finite(next)) return std::nullopt;
      before = now;
      f_before = f_now;
      now = next;
      if (std::abs(now - before) < kConverged * std::abs(now)) return now;
    }
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace softwall
