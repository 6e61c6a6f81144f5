#pragma once

#include <memory>
#include <type_traits>

#include <fftw3.h>

namespace softwall::pressure {

/// Cosine and sine transforms of `rows` real rows of n numbers, their first ones `distance` apart, in place,
/// at any address, in double precision; not normalised either way. Kinds: FFTW_REDFT10 (cosines),
/// FFTW_RODFT10, FFTW_RODFT00 (sines) and their inverses. Plans are estimated (fft.hpp says why).
class RealRows {
 public:
  struct Shape {
    int n = 0, rows = 0, distance = 0;
  };
  RealRows(const Shape& shape, fftw_r2r_kind forward, fftw_r2r_kind backward);
  void forward(double* first) const { execute(forward_, first); }
  void backward(double* first) const { execute(backward_, first); }

 private:
  struct Destroy {
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
  };
  using Owner = std::unique_ptr<std::remove_pointer_t<fftw_plan>, Destroy>;
  [[nodiscard]] static Owner plan(const Shape& shape, fftw_r2r_kind kind);
  static void execute(const Owner& plan, double* first);
  Owner forward_, backward_;  ///< empty when there is nothing to transform
};

}  // namespace softwall::pressure
