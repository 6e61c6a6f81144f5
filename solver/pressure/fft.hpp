#pragma once

#include <complex>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "solver/grid/grid.hpp"
#include "solver/pressure/fftw.hpp"

#include "solver/parallel/line_memory.hpp"

/// Owners of FFTW plans. Plans are estimated, not measured: a measured plan may differ from run to
/// run and with it the last bits of the result, and a restarted run must repeat an uninterrupted one bit for
/// bit.
namespace softwall::pressure {

using grid::Real;
using Complex = std::complex<Real>;
using Library = Fftw<Real>;

struct DestroyPlan {
  void operator()(Library::Plan p) const { Library::destroy(p); }
};
using PlanOwner = std::unique_ptr<std::remove_pointer_t<Library::Plan>, DestroyPlan>;

/// One row of n real numbers <-> n / 2 + 1 coefficients. Rows start at aligned addresses; the real row and,
/// on the way back, the coefficients are overwritten.
class RealRowTransform {
 public:
  explicit RealRowTransform(int n);
  void forward(Real* row, Complex* coefficients) const;
  void backward(Complex* coefficients, Real* row) const;

 private:
  PlanOwner forward_, backward_;
};

/// `rows` rows of n complex numbers, `stride` apart, in place; not normalised either way.
class ComplexRowsTransform {
 public:
  ComplexRowsTransform(int n, int rows, int stride);
  void forward(Complex* rows) const { execute(forward_, rows); }
  void backward(Complex* rows) const { execute(backward_, rows); }

 private:
  static void execute(const PlanOwner& plan, Complex* rows);
  PlanOwner forward_, backward_;  ///< empty when there is nothing to transform
};

}  // namespace softwall::pressure
