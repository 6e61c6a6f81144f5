#include "solver/pressure/poisson.hpp"

#include <algorithm>

namespace softwall::pressure {

namespace {

using parallel::RowBlock;

/// About as many bytes of coefficients as stay in a core's own cache while a block is worked on.
constexpr std::ptrdiff_t kBlockBytes = 256 * 1024;

std::ptrdiff_t rows_in_block(int stride, int rows) {
  const std::ptrdiff_t row_bytes = parallel::Transposition<Complex>::kPlanes * stride * sizeof(Complex);
  return std::clamp<std::ptrdiff_t>(kBlockBytes / row_bytes, 1, std::max(rows, 1));
}

}  // namespace

Poisson::Poisson(const Grid& g, const parallel::Decomposition& d, parallel::Profile* profile)
    : grid_(g),
      transform_x_(g.nx_global, g.dx),
      columns_to_x_(d.x_line(), {g.nz, g.ny, g.nx}, parallel::kY, parallel::kX, g.nx_global, profile),
      rows_(columns_to_x_.after()[parallel::kY]),
      turn_(d.z_line(), transform_x_.modes(), rows_, g.nz_global, profile),
      z_to_y_(d.x_line(), {turn_.own_modes().size(), rows_, g.nz_global}, parallel::kX, parallel::kY, g.ny,
              profile),
      row_stride_(parallel::whole_lines<Complex>(transform_x_.modes())),
      mode_stride_(parallel::whole_lines<Complex>(g.nz_global)),
      transform_z_(g.nz_global, rows_, mode_stride_),
      tridiagonals_(g, 2 * static_cast<std::size_t>(g.nz_global)),
      row_(static_cast<std::size_t>(g.nx_global)),
      next_row_(row_.size()),
      block_(static_cast<std::size_t>(rows_in_block(row_stride_, rows_) * row_stride_) *
             parallel::Transposition<Complex>::kPlanes),
      plane_(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(mode_stride_)) {
  const auto modes_z = parallel::share(g.nz_global, d.px(), d.x_line().rank());
  for (int m = turn_.own_modes().begin; m < turn_.own_modes().end; ++m)
    kappa2_x_.push_back(Real(transform_x_.wavenumber_squared(m)));
  for (int m = modes_z.begin; m < modes_z.end; ++m)
    kappa2_z_.insert(kappa2_z_.end(), 2, Real(periodic_wavenumber_squared(m, g.nz_global, g.dz)));
  holds_mean_ = turn_.own_modes().begin == 0 && modes_z.begin == 0 && modes_z.size() > 0;
  if (columns_to_x_.trivial()) return;
  columns_.resize(columns_to_x_.volume(columns_to_x_.before()));
  x_whole_.resize(columns_to_x_.volume(columns_to_x_.after()));
  z_whole_.resize(z_to_y_.volume(z_to_y_.before()));
  y_whole_.resize(z_to_y_.volume(z_to_y_.after()));
}

void Poisson::solve(PoissonRows& rows) {
  to_modes([&rows](int j, int k, Real* row) { rows.give_right_side(j, k, row); });
  if (columns_to_x_.trivial()) {
    for (int mode = 0; mode < turn_.own_modes().size(); ++mode) {
      forward_in_z(mode);
      solve_systems(plane_.data(), mode_stride_, mode);
      backward_in_z(mode);
    }
    turn_.to_planes();
    transform_back([&rows](int j, int k, const Real* row) { rows.take_solution(j, k, row); });
  } else {
    solve_with_shared_rows();
    turn_.to_planes();
    transform_back(
        [this](int j, int k, const Real* row) { std::copy_n(row, grid_.nx_global, whole_row(j, k)); });
    scatter_rows(rows);
  }
}

void Poisson::transform(FieldRows& field) {
  to_modes([&field](int j, int k, Real* row) { field.give(j, k, row); });
  if (!columns_to_x_.trivial()) columns_to_x_.release();
  for (int mode = 0; mode < turn_.own_modes().size(); ++mode) {
    forward_in_z(mode);
    field.take(turn_.own_modes().begin + mode, columns_to_x_.own_part(), plane_.data(), mode_stride_);
  }
  turn_.leave_modes();
}

template <class GiveRow>
void Poisson::to_modes(const GiveRow& give) {
  if (columns_to_x_.trivial()) {
    transform_rows(give);
  } else {
    gather_rows(give);
    transform_rows([this](int j, int k, Real* row) { std::copy_n(whole_row(j, k), grid_.nx_global, row); });
  }
  turn_.to_modes();
}

/// A few rows of a few planes at a time.
template <class Work>
void Poisson::for_each_block(const Work& work) const {
  constexpr int kPlanes = parallel::Transposition<Complex>::kPlanes;
  const int chunk = static_cast<int>(rows_in_block(row_stride_, rows_));
  for (int k = 0; k < grid_.nz; k += kPlanes) {
    for (int j = 0; j < rows_; j += chunk)
      work(RowBlock{k, std::min(k + kPlanes, grid_.nz), j, std::min(j + chunk, rows_)});
  }
}

/// The rows of a block two by two, with the places of their coefficients; the last of an odd number is its
/// own partner.
template <class Work>
void Poisson::for_each_pair(const RowBlock& b, const Work& work) {
  Complex* here = block_.data();
  for (int k = b.k0; k < b.k1; ++k) {
    for (int j = b.j0; j < b.j1; j += 2) {
      const int next = std::min(j + 1, b.j1 - 1);
      work(k, j, next, here, here + (next - j) * row_stride_);
      here += (next - j + 1) * row_stride_;
    }
  }
}

template <class GiveRow>
void Poisson::transform_rows(const GiveRow& give) {
  for_each_block([&](const RowBlock& b) {
    for_each_pair(b, [&](int k, int j, int next, Complex* here, Complex* there) {
      Real *const row = row_.data(), *const next_row = next > j ? next_row_.data() : row;
      give(j, k, row);
      if (next > j) give(next, k, next_row);
      transform_x_.forward(row, next_row, here, there);
    });
    turn_.pack(b, block_.data(), row_stride_);
  });
}

template <class TakeRow>
void Poisson::transform_back(const TakeRow& take) {
  for_each_block([&](const RowBlock& b) {
    turn_.unpack(b, block_.data(), row_stride_);
    for_each_pair(b, [&](int k, int j, int next, const Complex* here, const Complex* there) {
      transform_x_.backward(here, there, row_.data(), next_row_.data());
      take(j, k, row_.data());
      if (next > j) take(next, k, next_row_.data());
    });
  });
}

/// One mode in x goes through plane_: (y, z).
void Poisson::forward_in_z(int mode) {
  turn_.load(mode, plane_.data(), mode_stride_);
  transform_z_.forward(plane_.data());
}

void Poisson::backward_in_z(int mode) {
  transform_z_.backward(plane_.data());
  turn_.store(mode, plane_.data(), mode_stride_);
}

void Poisson::solve_systems(Complex* plane, std::ptrdiff_t stride, int mode) {
  const Real scale = Real(1 / (transform_x_.gain() * grid_.nz_global));
  tridiagonals_.solve(reinterpret_cast<Real*>(plane), 2 * stride, kappa2_x_[static_cast<std::size_t>(mode)],
                      kappa2_z_, scale);
  if (mode == 0 && holds_mean_) remove_mean(plane, stride);
}

/// The mean mode is determined up to a constant.
void Poisson::remove_mean(Complex* plane, std::ptrdiff_t stride) const {
  std::complex<double> mean = 0.0;
  for (int j = 0; j < grid_.ny; ++j)
    mean += std::complex<double>(plane[j * stride]) * grid_.dy[j] / grid_.height;
  for (int j = 0; j < grid_.ny; ++j) plane[j * stride] -= Complex(mean);
}

// What follows is needed only where x is shared, too.

Real* Poisson::whole_row(int j, int k) {
  return x_whole_.data() + (std::ptrdiff_t(k) * rows_ + j) * grid_.nx_global;
}

template <class GiveRow>
void Poisson::gather_rows(const GiveRow& give) {
  Real* row = columns_.data();
  for (int k = 0; k < grid_.nz; ++k) {
    for (int j = 0; j < grid_.ny; ++j, row += grid_.nx) give(j, k, row);
  }
  columns_to_x_.forward(columns_.data(), x_whole_.data());
}

void Poisson::scatter_rows(PoissonRows& to) {
  columns_to_x_.backward(x_whole_.data(), columns_.data());
  const Real* row = columns_.data();
  for (int k = 0; k < grid_.nz; ++k) {
    for (int j = 0; j < grid_.ny; ++j, row += grid_.nx) to.take_solution(j, k, row);
  }
}

void Poisson::solve_with_shared_rows() {
  const int modes_x = turn_.own_modes().size(), modes_z = z_to_y_.after()[parallel::kX];
  const std::ptrdiff_t nz = grid_.nz_global;
  const auto dense_row = [&](int mode, int j) {
    return z_whole_.data() + (std::ptrdiff_t(mode) * rows_ + j) * nz;
  };
  const auto plane_row = [&](int j) { return plane_.data() + std::ptrdiff_t(j) * mode_stride_; };
  for (int mode = 0; mode < modes_x; ++mode) {
    forward_in_z(mode);
    for (int j = 0; j < rows_; ++j) std::copy_n(plane_row(j), nz, dense_row(mode, j));
  }
  z_to_y_.forward(z_whole_.data(), y_whole_.data());
  for (int mode = 0; mode < modes_x; ++mode)
    solve_systems(y_whole_.data() + std::ptrdiff_t(mode) * grid_.ny * modes_z, modes_z, mode);
  z_to_y_.backward(y_whole_.data(), z_whole_.data());
  for (int mode = 0; mode < modes_x; ++mode) {
    for (int j = 0; j < rows_; ++j) std::copy_n(dense_row(mode, j), nz, plane_row(j));
    backward_in_z(mode);
  }
}

}  // namespace softwall::pressure
