#pragma once

#include <vector>

#include "solver/grid/field.hpp"
#include "solver/parallel/transfer.hpp"
#include "solver/parallel/transposition.hpp"
#include "solver/pressure/fourier_x.hpp"
#include "solver/pressure/tridiagonal.hpp"

/// Solves the second-order Poisson equation of the staggered grid directly:
///   (psi[i+1] - 2 psi[i] + psi[i-1]) / dx^2 + (the same in z)
///     + ((psi[j+1] - psi[j]) / dy_face[j+1] - (psi[j] - psi[j-1]) / dy_face[j]) / dy[j] = rhs,
/// periodic in x and z, zero normal derivative at the walls. Fourier transforms in x and z turn it into one
/// tridiagonal system in y for every wave number pair, with the modified wave numbers of the stencil,
///   kappa^2 = (2 - 2 cos(2 pi m / n)) / d^2,
/// so that the divergence of the projected velocity is zero to round-off. The mean of psi is set to zero.
///
/// What is done while data is in the cache, and what travels (extents slowest first; px = 1 on few ranks):
///   columns   (nz/pz, ny, nx/px)    the cells of the grid, given and taken row by row
///     px > 1: x made whole, y shared                                        transfer within a line in x
///   a few rows                      transform in x, axes turned             transposition within a line in z
///   a mode    (ny/px, nz)           transform in z
///     px > 1: y made whole, z modes shared                                  transfer within a line in x
///   a mode    (ny, nz/px)           tridiagonal systems, and all the way back
namespace softwall::pressure {

using grid::Grid;

/// Whose equation is solved: gives the right-hand side row by row and takes the solution row by row, each row
/// (j, k) of nx numbers once and in no promised order.
class PoissonRows {
 public:
  PoissonRows() = default;
  PoissonRows(const PoissonRows&) = delete;
  PoissonRows& operator=(const PoissonRows&) = delete;
  virtual ~PoissonRows() = default;

  virtual void give_right_side(int j, int k, Real* row) = 0;
  virtual void take_solution(int j, int k, const Real* row) = 0;
};

/// A field of which nothing but its Fourier coefficients is wanted: gives its rows as PoissonRows does, and
/// takes one mode in x after the other, those of this rank.
class FieldRows {
 public:
  FieldRows() = default;
  FieldRows(const FieldRows&) = delete;
  FieldRows& operator=(const FieldRows&) = delete;
  virtual ~FieldRows() = default;

  virtual void give(int j, int k, Real* row) = 0;
  /// Coefficient (mode, n) of row j, n = 0 .. nz - 1, at plane[(j - rows.begin) * stride + n], not
  /// normalised.
  virtual void take(int mode, parallel::Range rows, const Complex* plane, std::ptrdiff_t stride) = 0;
};

class Poisson {
 public:
  Poisson(const Grid& grid, const parallel::Decomposition& decomposition,
          parallel::Profile* profile = nullptr);

  /// Asks for all of the right-hand side before it hands out the first row of psi.
  void solve(PoissonRows& rows);

  /// Only the way to the coefficients, for statistics. Collective.
  void transform(FieldRows& field);

 private:
  template <class Work>
  void for_each_block(const Work& work) const;
  template <class Work>
  void for_each_pair(const parallel::RowBlock& block, const Work& work);
  template <class GiveRow>
  void transform_rows(const GiveRow& give);
  template <class TakeRow>
  void transform_back(const TakeRow& take);
  void forward_in_z(int mode);
  void backward_in_z(int mode);
  void solve_systems(Complex* plane, std::ptrdiff_t stride, int mode);
  void remove_mean(Complex* plane, std::ptrdiff_t stride) const;
  template <class GiveRow>
  void gather_rows(const GiveRow& give);
  template <class GiveRow>
  void to_modes(const GiveRow& give);
  void scatter_rows(PoissonRows& to);
  void solve_with_shared_rows();
  [[nodiscard]] Real* whole_row(int j, int k);

  const Grid& grid_;
  FourierX transform_x_;
  parallel::Transfer<Real> columns_to_x_;
  const int rows_;  ///< in y, of this rank, where x is whole
  parallel::Transposition<Complex> turn_;
  parallel::Transfer<Complex> z_to_y_;  ///< extents (mode in x, y, z)
  const int row_stride_, mode_stride_;  ///< padded lengths of a row of coefficients in x, and in z
  ComplexRowsTransform transform_z_;
  Tridiagonals tridiagonals_;
  std::vector<Real> kappa2_x_;  ///< of this rank's modes in x
  std::vector<Real> kappa2_z_;  ///< of this rank's modes in z, each twice: real and imaginary part
  bool holds_mean_ = false;     ///< this rank has the mode kx = kz = 0
  parallel::LineVector<Real> row_, next_row_;        ///< a pair of rows of cells
  parallel::LineVector<Complex> block_;              ///< coefficients in x of a few rows
  parallel::LineVector<Complex> plane_;              ///< one mode in x: coefficients in z of all rows
  parallel::LineVector<Real> columns_, x_whole_;     ///< px > 1
  parallel::LineVector<Complex> z_whole_, y_whole_;  ///< px > 1
};

}  // namespace softwall::pressure
