#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

/// Small waves v(y) cos(k x) exp(s t) of a viscous fluid at rest under a bonded viscous neo-Hookean layer,
/// both of density 1, between rigid walls at y = 0 and y = depth + thickness. Linear theory: in each layer
///   (D^2 - k^2)(D^2 - m^2) v = 0,   D = d/dy,   m^2 = k^2 + s / N,
///   N = nu in the fluid, nu_s + G / s in the solid,
///   u = -v'/k sin(k x),   p = [N (v''' - k^2 v') - s v'] / k^2 cos(k x),   displacement xi = velocity / s,
/// with v = v' = 0 on the walls and v, v', N (v'' + k^2 v), -p + 2 N v' continuous at the interface. These
/// are eight conditions for the eight coefficients of the solutions; a rate s is one for which their
/// determinant vanishes.
namespace softwall {

/// Lengths in h, velocities in U_b.
struct WaveLayers {
  double depth = 2, thickness = 0;  ///< of the fluid, of the solid
  double nu_f = 0, nu_s = 0;        ///< kinematic viscosities
  double G = 0;                     ///< modulus of transverse elasticity
  double k = 0;                     ///< wave number, 2 pi / wavelength
};

/// Those of a case: fluid 2 deep, one wave in length_x.
[[nodiscard]] WaveLayers wave_layers(double reynolds, double length_x, double layer_height, double G,
                                     double viscosity_ratio);

class InterfaceMode {
 public:
  using Complex = std::complex<double>;

  /// `s`: a rate of these layers (nearest_rate), U_b / h: growth and angular frequency. Throws
  /// std::domain_error when the conditions cannot be solved at all.
  InterfaceMode(const WaveLayers& layers, Complex s);

  [[nodiscard]] Complex rate() const { return s_; }
  /// Derivative of v of the given order at y; v is known up to a factor.
  [[nodiscard]] Complex v(double y, int order = 0) const;

 private:
  WaveLayers layers_;
  Complex s_;
  std::vector<Complex> c_;  ///< coefficients of the solutions, those of the fluid, then those of the solid
};

/// The rate that Newton's method (with secants) reaches from a guess; empty when it reaches none.
[[nodiscard]] std::optional<InterfaceMode::Complex> nearest_rate(const WaveLayers& layers,
                                                                 InterfaceMode::Complex guess);

}  // namespace softwall
