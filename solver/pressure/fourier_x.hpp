#pragma once

#include <cmath>
#include <numbers>

#include "solver/pressure/fft.hpp"

/// The x direction of the Poisson solver: which modes diagonalise the second difference along a row of cells,
/// and the transform of two rows to their coefficients and back. Another condition at the ends of the row
/// needs another class with these members; the solver asks for nothing else.
namespace softwall::pressure {

/// -kappa^2 of mode m of the periodic second difference with n cells of width d.
inline double periodic_wavenumber_squared(int m, int n, double d) {
  const double half = std::sin(std::numbers::pi * m / n);
  return 4 * half * half / (d * d);
}

/// Periodic rows: real Fourier transform.
class FourierX {
 public:
  FourierX(int n, double dx) : n_(n), dx_(dx), transform_(n) {}

  [[nodiscard]] int modes() const { return n_ / 2 + 1; }
  [[nodiscard]] double wavenumber_squared(int mode) const {
    return periodic_wavenumber_squared(mode, n_, dx_);
  }
  /// What backward(forward(row)) multiplies the row with.
  [[nodiscard]] double gain() const { return n_; }

  /// Two rows of n numbers <-> modes() coefficients each; they may be the same row twice.
  void forward(const Real* a, const Real* b, Complex* a_hat, Complex* b_hat) {
    transform_.forward(a, b, a_hat, b_hat);
  }
  void backward(const Complex* a_hat, const Complex* b_hat, Real* a, Real* b) {
    transform_.backward(a_hat, b_hat, a, b);
  }

 private:
  int n_;
  double dx_;
  RealRowPairTransform transform_;
};

}  // namespace softwall::pressure
