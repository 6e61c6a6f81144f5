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

}  // namespace

RealRowTransform::RealRowTransform(int n) {
  parallel::LineVector<Real> row(static_cast<std::size_t>(n));
  parallel::LineVector<Complex> coefficients(static_cast<std::size_t>(n) / 2 + 1);
  forward_ = owned(Library::plan_real_row(n, row.data(), coefficients.data()));
  backward_ = owned(Library::plan_real_row_back(n, coefficients.data(), row.data()));
}

void RealRowTransform::forward(Real* row, Complex* coefficients) const {
  Library::execute_real_row(forward_.get(), row, coefficients);
}

void RealRowTransform::backward(Complex* coefficients, Real* row) const {
  Library::execute_real_row_back(backward_.get(), coefficients, row);
}

ComplexRowsTransform::ComplexRowsTransform(int n, int rows, int stride)
    : forward_(plan_rows(n, rows, stride, FFTW_FORWARD)),
      backward_(plan_rows(n, rows, stride, FFTW_BACKWARD)) {}

void ComplexRowsTransform::execute(const PlanOwner& plan, Complex* rows) {
  if (plan) Library::execute_rows(plan.get(), rows);
}

}  // namespace softwall::pressure
