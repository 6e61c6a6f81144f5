#include "solver/pressure/closed_box/box_solver.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace softwall::pressure {

namespace {

RealRows transform_in_x(BoxQuantity quantity, int nx, int rows) {
  switch (quantity) {
    case BoxQuantity::kU:
      return {{nx - 1, rows, nx}, FFTW_RODFT00, FFTW_RODFT00};
    case BoxQuantity::kV:
      return {{nx, rows, nx}, FFTW_RODFT10, FFTW_RODFT01};
    case BoxQuantity::kPressure:
      break;
  }
  return {{nx, rows, nx}, FFTW_REDFT10, FFTW_REDFT01};
}

}  // namespace

BoxSolver::BoxSolver(const Grid& g, const parallel::Decomposition& d, BoxQuantity quantity)
    : grid_(g),
      transfer_(d.x_line(), {g.nz, g.ny, g.nx}, parallel::kY, parallel::kX, g.nx_global),
      columns_(transfer_.volume(transfer_.before())),
      rows_(transfer_.trivial() ? 0 : transfer_.volume(transfer_.after())),
      transform_(transform_in_x(quantity, g.nx_global, transfer_.after()[parallel::kY])),
      first_column_(quantity == BoxQuantity::kU ? 1 : 0),
      first_row_(quantity == BoxQuantity::kV ? 1 : 0),
      determined_(quantity != BoxQuantity::kPressure) {
  if (g.nz_global != 1) throw std::invalid_argument("a closed box has one cell in z");
  const int lowest = quantity == BoxQuantity::kV ? 1 : 0;  // wave number of the first sine on centers
  for (int i = 0; i < g.nx; ++i) {
    const double half = std::sin(std::numbers::pi * (g.x_begin + i + lowest) / (2 * g.nx_global));
    kappa2_.push_back(4 * half * half / (g.dx * g.dx));
  }
  for (int j = 0; j < g.ny; ++j) {
    const bool on_faces = quantity == BoxQuantity::kV, mirrored = quantity == BoxQuantity::kU;
    double low = g.inv_dy[j] * g.inv_dy_face[j], high = g.inv_dy[j] * g.inv_dy_face[j + 1], wall = 0;
    if (on_faces) {
      low = g.inv_dy_face[j] * g.inv_dy[j - 1];
      high = g.inv_dy_face[j] * g.inv_dy[j];
    }
    if (j == first_row_) {
      wall += on_faces ? low : (mirrored ? 2 * low : 0);
      low = 0;
    }
    if (j == g.ny - 1) {
      wall += on_faces ? high : (mirrored ? 2 * high : 0);
      high = 0;
    }
    lower_.push_back(low);
    upper_.push_back(high);
    wall_.push_back(wall);
  }
  factor_.resize(columns_.size());
}

void BoxSolver::solve(double shift) {
  transform(true);
  eliminate(shift);
  if (!determined_ && shift == 0 && grid_.x_begin == 0) remove_mean();
  transform(false);
}

void BoxSolver::transform(bool forward) {
  if (!transfer_.trivial()) transfer_.forward(columns_.data(), rows_.data());
  double* const first = (transfer_.trivial() ? columns_.data() : rows_.data()) + first_column_;
  if (forward) {
    transform_.forward(first);
  } else {
    transform_.backward(first);
  }
  if (!transfer_.trivial()) transfer_.backward(rows_.data(), columns_.data());
}

/// Thomas algorithm for all wave numbers at once. With the diagonal -(lower + upper + wall + kappa2 + shift)
/// the modified upper diagonal f and the modified right-hand side r obey
///   f[j] = upper / (lower (1 - f[j-1]) + upper + wall + kappa2 + shift),
///   r[j] = (lower r[j-1] - rhs) / (the same denominator).
void BoxSolver::eliminate(double shift) {
  const std::ptrdiff_t nx = grid_.nx;
  const double scale = 1.0 / (2.0 * grid_.nx_global);  // FFTW's transforms are not normalised
  double *const r = columns_.data(), *const f = factor_.data();
  const double* const kappa2 = kappa2_.data();
  for (int j = first_row_; j < grid_.ny; ++j) {
    const auto row_index = static_cast<std::size_t>(j);
    const double lower = lower_[row_index], upper = upper_[row_index], own = wall_[row_index] + shift;
    const double carry = j > first_row_ ? 1.0 : 0.0;
    const std::ptrdiff_t row = j * nx, below = j > first_row_ ? row - nx : row;
#pragma omp simd
    for (std::ptrdiff_t m = 0; m < nx; ++m) {
      const double denominator = lower * (1.0 - carry * f[below + m]) + upper + kappa2[m] + own;
      const double inverse = denominator > 0.0 ? 1.0 / denominator : 0.0;  // top row of the constant mode
      f[row + m] = denominator > 0.0 ? upper / denominator : 0.0;          // exactly 1 for the constant mode
      r[row + m] = (lower * carry * r[below + m] - scale * r[row + m]) * inverse;
    }
  }
  for (int j = grid_.ny - 2; j >= first_row_; --j) {
    const std::ptrdiff_t row = j * nx;
#pragma omp simd
    for (std::ptrdiff_t m = 0; m < nx; ++m) r[row + m] += f[row + m] * r[row + nx + m];
  }
}

/// Elimination has fixed the top row of the constant mode to 0.
void BoxSolver::remove_mean() {
  double mean = 0;
  double* const r = columns_.data();
  for (int j = 0; j < grid_.ny; ++j) mean += r[j * std::ptrdiff_t(grid_.nx)] * grid_.dy[j] / grid_.height;
  for (int j = 0; j < grid_.ny; ++j) r[j * std::ptrdiff_t(grid_.nx)] -= mean;
}

}  // namespace softwall::pressure
