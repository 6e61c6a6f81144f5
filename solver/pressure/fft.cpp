#include "solver/pressure/fft.hpp"

namespace softwall::pressure {

namespace {

fftw_complex* raw(Complex* z) { return reinterpret_cast<fftw_complex*>(z); }

PlanOwner owned(fftw_plan plan) {
  if (!plan) throw std::runtime_error("FFTW cannot plan this transform");
  return PlanOwner(plan);
}

PlanOwner plan_rows(int n, int rows, int stride, int sign) {
  if (rows == 0) return {};
  Aligned<Complex> sample(static_cast<std::size_t>(rows) * static_cast<std::size_t>(stride));
  return owned(fftw_plan_many_dft(1, &n, rows, raw(sample.data()), nullptr, 1, stride, raw(sample.data()),
                                  nullptr, 1, stride, sign, FFTW_ESTIMATE));
}

}  // namespace

RealRowTransform::RealRowTransform(int n) {
  Aligned<double> row(static_cast<std::size_t>(n));
  Aligned<Complex> coefficients(static_cast<std::size_t>(n) / 2 + 1);
  constexpr unsigned kFlags = FFTW_ESTIMATE | FFTW_DESTROY_INPUT;
  forward_ = owned(fftw_plan_dft_r2c_1d(n, row.data(), raw(coefficients.data()), kFlags));
  backward_ = owned(fftw_plan_dft_c2r_1d(n, raw(coefficients.data()), row.data(), kFlags));
}

void RealRowTransform::forward(double* row, Complex* coefficients) const {
  fftw_execute_dft_r2c(forward_.get(), row, raw(coefficients));
}

void RealRowTransform::backward(Complex* coefficients, double* row) const {
  fftw_execute_dft_c2r(backward_.get(), raw(coefficients), row);
}

ComplexRowsTransform::ComplexRowsTransform(int n, int rows, int stride)
    : forward_(plan_rows(n, rows, stride, FFTW_FORWARD)),
      backward_(plan_rows(n, rows, stride, FFTW_BACKWARD)) {}

void ComplexRowsTransform::execute(const PlanOwner& plan, Complex* rows) {
  if (plan) fftw_execute_dft(plan.get(), raw(rows), raw(rows));
}

}  // namespace softwall::pressure
