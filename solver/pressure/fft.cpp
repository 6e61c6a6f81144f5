#include "solver/pressure/fft.hpp"

namespace softwall::pressure {

namespace {

PlanOwner owned(Library::Plan plan) {
  if (!plan) throw std::runtime_error("FFTW cannot plan this transform");
  return PlanOwner(plan);
}

PlanOwner plan_rows(int n, int rows, int stride, int sign) {
  if (rows == 0) return {};
  parallel::LineVector<Complex> sample(static_cast<std::size_t>(rows) * static_cast<std::size_t>(stride));
  return owned(Library::plan_rows(n, rows, stride, sample.data(), sign));
}

/// Complex numbers as pairs of real ones: the compiler makes vectors of these only.
Real* numbers(Complex* z) { return reinterpret_cast<Real*>(z); }
const Real* numbers(const Complex* z) { return reinterpret_cast<const Real*>(z); }

/// z = a + i b.
void join_rows(const Real* a, const Real* b, Real* z, int n) {
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    z[2 * i] = a[i];
    z[2 * i + 1] = b[i];
  }
}

void part_rows(const Real* z, Real* a, Real* b, int n) {
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    a[i] = z[2 * i];
    b[i] = z[2 * i + 1];
  }
}

/// Separates the coefficients of z = a + i b into those of a and b; the mean is real in both.
void part_coefficients(const Real* z, Real* a, Real* b, int n) {
  a[0] = z[0];
  b[0] = z[1];
  a[1] = b[1] = 0;
  const Real half = Real(0.5);
#pragma omp simd
  for (int m = 1; m <= n / 2; ++m) {
    const Real re = z[2 * m], im = z[2 * m + 1], other_re = z[2 * (n - m)], other_im = z[2 * (n - m) + 1];
    a[2 * m] = half * (re + other_re);
    a[2 * m + 1] = half * (im - other_im);
    b[2 * m] = half * (im + other_im);
    b[2 * m + 1] = half * (other_re - re);
  }
}

/// z^[m] = a^[m] + i b^[m] and z^[n - m] = conj a^[m] + i conj b^[m].
void join_coefficients(const Real* a, const Real* b, Real* z, int n) {
  z[0] = a[0];
  z[1] = b[0];
#pragma omp simd
  for (int m = 1; m <= n / 2; ++m) {
    z[2 * m] = a[2 * m] - b[2 * m + 1];
    z[2 * m + 1] = a[2 * m + 1] + b[2 * m];
  }
#pragma omp simd
  for (int m = n / 2 + 1; m < n; ++m) {
    z[2 * m] = a[2 * (n - m)] + b[2 * (n - m) + 1];
    z[2 * m + 1] = b[2 * (n - m)] - a[2 * (n - m) + 1];
  }
}

}  // namespace

RealRowPairTransform::RealRowPairTransform(int n)
    : n_(n),
      z_(static_cast<std::size_t>(n)),
      z_hat_(static_cast<std::size_t>(n)),
      forward_(owned(Library::plan_row(n, z_.data(), z_hat_.data(), FFTW_FORWARD))),
      backward_(owned(Library::plan_row(n, z_hat_.data(), z_.data(), FFTW_BACKWARD))) {}

void RealRowPairTransform::forward(const Real* a, const Real* b, Complex* a_hat, Complex* b_hat) {
  join_rows(a, b, numbers(z_.data()), n_);
  Library::execute_row(forward_.get(), z_.data(), z_hat_.data());
  part_coefficients(numbers(z_hat_.data()), numbers(a_hat), numbers(b_hat), n_);
}

void RealRowPairTransform::backward(const Complex* a_hat, const Complex* b_hat, Real* a, Real* b) {
  join_coefficients(numbers(a_hat), numbers(b_hat), numbers(z_hat_.data()), n_);
  Library::execute_row(backward_.get(), z_hat_.data(), z_.data());
  part_rows(numbers(z_.data()), a, b, n_);
}

ComplexRowsTransform::ComplexRowsTransform(int n, int rows, int stride)
    : forward_(plan_rows(n, rows, stride, FFTW_FORWARD)),
      backward_(plan_rows(n, rows, stride, FFTW_BACKWARD)) {}

void ComplexRowsTransform::execute(const PlanOwner& plan, Complex* rows) {
  if (plan) Library::execute_rows(plan.get(), rows);
}

}  // namespace softwall::pressure
