#pragma once

#include <span>
#include <vector>

#include "solver/grid/grid.hpp"

/// The y direction of the Poisson solver: for every pair of wave numbers a tridiagonal system,
///   lower[j] psi[j-1] - (lower[j] + upper[j] + kappa^2) psi[j] + upper[j] psi[j+1] = rhs[j],
/// with zero normal derivative at both walls.
namespace softwall::pressure {

using grid::Real;

class Tridiagonals {
 public:
  /// `most`: systems solved at once, side by side.
  Tridiagonals(const grid::Grid& grid, std::size_t most);

  /// Solves a real system for each entry of kappa2, with kappa^2 = kappa2_x + kappa2[m]; a complex one is
  /// two. values[j * stride + m]: `scale` times it is the right-hand side on entry, psi on return. Where
  /// kappa^2 = 0 the solution is fixed up to a constant: the top row is set to 0.
  void solve(Real* values, std::ptrdiff_t stride, Real kappa2_x, std::span<const Real> kappa2, Real scale);

 private:
  std::vector<Real> lower_, upper_;  ///< off-diagonals, one a row
  std::vector<Real> reduced_;        ///< work: 1 - upper / pivot of the row below
  std::vector<Real> ratio_;          ///< work: upper / pivot, (row, system)
};

}  // namespace softwall::pressure
