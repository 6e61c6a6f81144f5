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

/// Rows of n real numbers <-> n / 2 + 1 coefficients, two rows at a time: a and b travel as one complex row
/// z = a + i b, of whose coefficients
///   a^[m] = (z^[m] + conj z^[n - m]) / 2,   b^[m] = (z^[m] - conj z^[n - m]) / 2i.
/// FFTW's complex transforms fill vectors and its real ones hardly do: of one row of 128 the latter take as
/// long in single precision as in double. Not normalised either way; the rows of a pair may be the same.
class RealRowPairTransform {
 public:
  explicit RealRowPairTransform(int n);
  void forward(const Real* a, const Real* b, Complex* a_hat, Complex* b_hat);
  void backward(const Complex* a_hat, const Complex* b_hat, Real* a, Real* b);

 private:
  const int n_;
  parallel::LineVector<Complex> z_, z_hat_;
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
