#pragma once

#include <vector>

#include "solver/grid/field.hpp"
#include "solver/parallel/transfer.hpp"
#include "solver/pressure/closed_box/real_rows.hpp"

/// Solves the second-order equation of the staggered grid
///   (laplacian - shift) q = rhs,   shift >= 0,
/// directly in a two-dimensional closed box (one cell in z): real transforms in x turn it into one
/// tridiagonal system in y for every wave number, with the modified wave numbers of the stencil,
///   kappa^2 = 4 sin^2(pi m / (2 nx)) / dx^2,
/// so that the difference equation holds to round-off.
///
///   quantity    in x                                       in y
///   pressure    centers, dq/dx = 0: cosines (REDFT10, 01)  centers, dq/dy = 0
///   u           faces, q = 0: sines (RODFT00)              centers, q = 0 midway to the mirrored cell
///   v           centers, q = 0: sines (RODFT10, 01)        faces, q = 0
///
/// Always in double precision. Columns are split in x between the ranks, as everywhere. For the transforms
/// rows are made whole instead; the tridiagonal systems are again solved in whole columns, of wave numbers
/// instead of cells.
namespace softwall::pressure {

using grid::Grid;

enum class BoxQuantity { kPressure, kU, kV };

class BoxSolver {
 public:
  /// Throws std::invalid_argument for a grid of more than one cell in z.
  BoxSolver(const Grid& grid, const parallel::Decomposition& decomposition, BoxQuantity quantity);

  /// This rank's right-hand side on entry, the solution on return: dense, (ny, nx), x fastest; where the
  /// quantity lives on faces, what stands on the walls (row 0, the first column) is not used.
  [[nodiscard]] double* values() { return columns_.data(); }
  /// With shift = 0 the pressure is determined up to a constant: its mean is set to zero.
  void solve(double shift);

 private:
  void transform(bool forward);
  void eliminate(double shift);
  void remove_mean();

  const Grid& grid_;
  parallel::Transfer<double> transfer_;
  std::vector<double> columns_, rows_;
  RealRows transform_;
  int first_column_ = 0;                      ///< of what is transformed: 1 for u
  int first_row_ = 0;                         ///< 1 for v
  bool determined_ = true;                    ///< false for the pressure
  std::vector<double> kappa2_;                ///< of this rank's wave numbers
  std::vector<double> lower_, upper_, wall_;  ///< of the y operator, one a row: to the neighbours; to a
                                              ///< mirrored cell
  std::vector<double> factor_;                ///< work: modified upper diagonal, (ny, nx)
};

}  // namespace softwall::pressure
