#include "solver/pressure/fft.hpp"

namespace softwall::pressure {

namespace {
fftw_complex* raw(Complex* z) { return reinterpret_cast<fftw_complex*>(z); }
}  // namespace

Plan plan_real_to_complex(int n, int rows, double* real, Complex* complex) {
  return Plan(fftw_plan_many_dft_r2c(1, &n, rows, real, nullptr, 1, n, raw(complex), nullptr, 1, n / 2 + 1,
                                     FFTW_ESTIMATE));
}

Plan plan_complex_to_real(int n, int rows, Complex* complex, double* real) {
  return Plan(fftw_plan_many_dft_c2r(1, &n, rows, raw(complex), nullptr, 1, n / 2 + 1, real, nullptr, 1, n,
                                     FFTW_ESTIMATE | FFTW_DESTROY_INPUT));
}

Plan plan_columns(int n, int columns, Complex* data, int sign) {
  if (columns == 0) return {};
  return Plan(fftw_plan_many_dft(1, &n, columns, raw(data), nullptr, columns, 1, raw(data), nullptr, columns,
                                 1, sign, FFTW_ESTIMATE));
}

}  // namespace softwall::pressure
