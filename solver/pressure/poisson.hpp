#pragma once

#include <vector>

#include "solver/grid/field.hpp"
#include "solver/parallel/transfer.hpp"
#include "solver/pressure/fft.hpp"

/// Solves the second-order Poisson equation of the staggered grid directly:
///   (psi[i+1] - 2 psi[i] + psi[i-1]) / dx^2 + (the same in z)
///     + ((psi[j+1] - psi[j]) / dy_face[j+1] - (psi[j] - psi[j-1]) / dy_face[j]) / dy[j] = rhs,
/// periodic in x and z, zero normal derivative at the walls. Fourier transforms in x and z turn it into one
/// tridiagonal system in y for every wave number pair, with the modified wave numbers of the stencil,
///   kappa^2 = (2 - 2 cos(2 pi m / n)) / d^2,
/// so that the divergence of the projected velocity is zero to round-off. The mean of psi is set to zero.
///
/// Layouts (extents z, y, x):   columns   (nz/pz, ny,    nx/px)   the cells of the grid
///                              x_whole   (nz/pz, ny/px, nx)      real, then nx/2 + 1 complex coefficients
///                              z_whole   (nz,    ny/px, nkx/pz)
///                              y_whole   (nz/px, ny,    nkx/pz)  where the tridiagonal systems are solved
namespace softwall::pressure {

using grid::Grid;
using grid::Real;

class Poisson {
 public:
  Poisson(const Grid& grid, const parallel::Decomposition& decomposition);

  /// This rank's right-hand side on entry, psi on return: dense, (nz, ny, nx), x fastest.
  [[nodiscard]] Real* values() { return columns_.data(); }
  void solve();

 private:
  void solve_tridiagonals(Complex* spectrum);
  void eliminate(Complex* plane, double kappa2_z);

  const Grid& grid_;
  parallel::Transfer<double> columns_to_x_;
  parallel::Transfer<Complex> x_to_z_, z_to_y_;
  Aligned<double> columns_, x_whole_;
  Aligned<Complex> x_spectrum_, z_whole_, y_whole_;
  Plan forward_x_, backward_x_, forward_z_, backward_z_;
  std::vector<double> kappa2_x_, kappa2_z_;  ///< of this rank's modes in y_whole
  std::vector<double> lower_, upper_;        ///< off-diagonals of the y operator, one a row
  std::vector<double> factor_;               ///< work: modified upper diagonal, (ny, modes in x)
  bool holds_mean_ = false;                  ///< this rank has the mode kx = kz = 0
};

}  // namespace softwall::pressure
