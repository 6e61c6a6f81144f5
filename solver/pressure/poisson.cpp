#include "solver/pressure/poisson.hpp"

#include <cmath>
#include <numbers>

namespace softwall::pressure {

namespace {

using parallel::Extents;

/// (2 - 2 cos(2 pi m / n)) / d^2 of the modes in `part`.
std::vector<double> modified_wavenumbers(int n, double d, parallel::Range part) {
  std::vector<double> kappa2;
  for (int m = part.begin; m < part.end; ++m) {
    const double half = std::sin(std::numbers::pi * m / n);
    kappa2.push_back(4.0 * half * half / (d * d));
  }
  return kappa2;
}

Extents with_x(Extents e, int nx) {
  e[parallel::kX] = nx;
  return e;
}

int plane(const Extents& e) { return e[parallel::kY] * e[parallel::kX]; }

}  // namespace

Poisson::Poisson(const Grid& g, const parallel::Decomposition& d)
    : grid_(g),
      columns_to_x_(d.x_line(), {g.nz, g.ny, g.nx}, parallel::kY, parallel::kX, g.nx_global),
      x_to_z_(d.z_line(), with_x(columns_to_x_.after(), g.nx_global / 2 + 1), parallel::kX, parallel::kZ,
              g.nz_global),
      z_to_y_(d.x_line(), x_to_z_.after(), parallel::kZ, parallel::kY, g.ny),
      columns_(columns_to_x_.volume(columns_to_x_.before())),
      x_whole_(columns_to_x_.trivial() ? 0 : columns_to_x_.volume(columns_to_x_.after())),
      x_spectrum_(x_to_z_.volume(x_to_z_.before())),
      z_whole_(x_to_z_.trivial() ? 0 : x_to_z_.volume(x_to_z_.after())),
      y_whole_(z_to_y_.trivial() ? 0 : z_to_y_.volume(z_to_y_.after())),
      forward_x_(plan_real_to_complex(g.nx_global, columns_to_x_.after()[0] * columns_to_x_.after()[1],
                                      columns_to_x_.trivial() ? columns_.data() : x_whole_.data(),
                                      x_spectrum_.data())),
      backward_x_(plan_complex_to_real(g.nx_global, columns_to_x_.after()[0] * columns_to_x_.after()[1],
                                       x_spectrum_.data(),
                                       columns_to_x_.trivial() ? columns_.data() : x_whole_.data())),
      forward_z_(plan_columns(g.nz_global, plane(x_to_z_.after()),
                              x_to_z_.trivial() ? x_spectrum_.data() : z_whole_.data(), FFTW_FORWARD)),
      backward_z_(plan_columns(g.nz_global, plane(x_to_z_.after()),
                               x_to_z_.trivial() ? x_spectrum_.data() : z_whole_.data(), FFTW_BACKWARD)) {
  const auto modes_x = parallel::share(g.nx_global / 2 + 1, d.pz(), d.z_line().rank());
  const auto modes_z = parallel::share(g.nz_global, d.px(), d.x_line().rank());
  kappa2_x_ = modified_wavenumbers(g.nx_global, g.dx, modes_x);
  kappa2_z_ = modified_wavenumbers(g.nz_global, g.dz, modes_z);
  holds_mean_ = modes_x.begin == 0 && modes_x.size() > 0 && modes_z.begin == 0 && modes_z.size() > 0;
  for (int j = 0; j < g.ny; ++j) {
    lower_.push_back(j > 0 ? g.inv_dy[j] * g.inv_dy_face[j] : 0.0);
    upper_.push_back(j < g.ny - 1 ? g.inv_dy[j] * g.inv_dy_face[j + 1] : 0.0);
  }
  factor_.resize(static_cast<std::size_t>(g.ny) * kappa2_x_.size());
}

void Poisson::solve() {
  if (!columns_to_x_.trivial()) columns_to_x_.forward(columns_.data(), x_whole_.data());
  forward_x_.execute();
  Complex* spectrum = x_spectrum_.data();
  if (!x_to_z_.trivial()) x_to_z_.forward(std::exchange(spectrum, z_whole_.data()), z_whole_.data());
  forward_z_.execute();
  Complex* const z_spectrum = spectrum;
  if (!z_to_y_.trivial()) z_to_y_.forward(std::exchange(spectrum, y_whole_.data()), y_whole_.data());

  solve_tridiagonals(spectrum);

  if (!z_to_y_.trivial()) z_to_y_.backward(y_whole_.data(), z_spectrum);
  backward_z_.execute();
  if (!x_to_z_.trivial()) x_to_z_.backward(z_whole_.data(), x_spectrum_.data());
  backward_x_.execute();
  if (!columns_to_x_.trivial()) columns_to_x_.backward(x_whole_.data(), columns_.data());
}

void Poisson::solve_tridiagonals(Complex* spectrum) {
  const std::size_t plane_size = static_cast<std::size_t>(grid_.ny) * kappa2_x_.size();
  for (std::size_t kz = 0; kz < kappa2_z_.size(); ++kz) eliminate(spectrum + kz * plane_size, kappa2_z_[kz]);
  if (!holds_mean_) return;
  // The mean mode is determined up to a constant: elimination fixed the top row to 0, now remove the mean.
  const std::size_t modes = kappa2_x_.size();
  Complex mean = 0.0;
  for (int j = 0; j < grid_.ny; ++j)
    mean += spectrum[static_cast<std::size_t>(j) * modes] * grid_.dy[j] / grid_.height;
  for (int j = 0; j < grid_.ny; ++j) spectrum[static_cast<std::size_t>(j) * modes] -= mean;
}

/// Thomas algorithm for all x modes of one z mode at once. With the diagonal -(lower + upper + kappa2) the
/// modified upper diagonal f and the modified right-hand side r obey
///   f[j] = upper / (lower (1 - f[j-1]) + upper + kappa2),   r[j] = (lower r[j-1] - rhs) / (the same
///   denominator).
void Poisson::eliminate(Complex* spectrum, double kappa2_z) {
  const auto modes = static_cast<std::ptrdiff_t>(kappa2_x_.size());
  const double scale =
      1.0 / (double(grid_.nx_global) * grid_.nz_global);  // FFTW's transforms are not normalised
  auto* const r = reinterpret_cast<double*>(spectrum);
  double* const f = factor_.data();
  const double* const kappa2_x = kappa2_x_.data();
  for (int j = 0; j < grid_.ny; ++j) {
    const double lower = lower_[static_cast<std::size_t>(j)], upper = upper_[static_cast<std::size_t>(j)];
    const std::ptrdiff_t row = j * modes, below = j > 0 ? row - modes : row;
    const double carry = j > 0 ? 1.0 : 0.0;
#pragma omp simd
    for (std::ptrdiff_t m = 0; m < modes; ++m) {
      const double denominator = lower * (1.0 - carry * f[below + m]) + upper + kappa2_x[m] + kappa2_z;
      const double inverse = denominator > 0.0 ? 1.0 / denominator : 0.0;  // top row of the mean mode
      f[row + m] = denominator > 0.0 ? upper / denominator : 0.0;          // exactly 1 for the mean mode
      r[2 * (row + m)] = (lower * carry * r[2 * (below + m)] - scale * r[2 * (row + m)]) * inverse;
      r[2 * (row + m) + 1] =
          (lower * carry * r[2 * (below + m) + 1] - scale * r[2 * (row + m) + 1]) * inverse;
    }
  }
  for (int j = grid_.ny - 2; j >= 0; --j) {
    const std::ptrdiff_t row = j * modes;
#pragma omp simd
    for (std::ptrdiff_t m = 0; m < modes; ++m) {
      r[2 * (row + m)] += f[row + m] * r[2 * (row + modes + m)];
      r[2 * (row + m) + 1] += f[row + m] * r[2 * (row + modes + m) + 1];
    }
  }
}

}  // namespace softwall::pressure
