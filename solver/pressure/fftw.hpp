#pragma once

#include <complex>
#include <cstddef>

#include <fftw3.h>

/// FFTW's two libraries, fftw3 and fftw3f, under one name for each function: Fftw<double> and Fftw<float>.
/// Plans are estimated, not measured (fft.hpp says why).
namespace softwall::pressure {

template <class T>
struct Fftw;

template <>
struct Fftw<double> {
  using Complex = std::complex<double>;
  using Plan = fftw_plan;
  static fftw_complex* raw(Complex* z) { return reinterpret_cast<fftw_complex*>(z); }

  static void destroy(Plan p) { fftw_destroy_plan(p); }

  /// n real numbers -> n / 2 + 1 coefficients, and back.
  static Plan plan_real_row(int n, double* row, Complex* out) {
    return fftw_plan_dft_r2c_1d(n, row, raw(out), FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
  }
  static Plan plan_real_row_back(int n, Complex* in, double* row) {
    return fftw_plan_dft_c2r_1d(n, raw(in), row, FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
  }
  /// `rows` rows of n complex numbers, `stride` apart, in place.
  static Plan plan_rows(int n, int rows, int stride, Complex* z, int sign) {
    return fftw_plan_many_dft(1, &n, rows, raw(z), nullptr, 1, stride, raw(z), nullptr, 1, stride, sign,
                              FFTW_ESTIMATE);
  }

  static void execute_real_row(Plan p, double* row, Complex* out) { fftw_execute_dft_r2c(p, row, raw(out)); }
  static void execute_real_row_back(Plan p, Complex* in, double* row) {
    fftw_execute_dft_c2r(p, raw(in), row);
  }
  static void execute_rows(Plan p, Complex* z) { fftw_execute_dft(p, raw(z), raw(z)); }
};

template <>
struct Fftw<float> {
  using Complex = std::complex<float>;
  using Plan = fftwf_plan;
  static fftwf_complex* raw(Complex* z) { return reinterpret_cast<fftwf_complex*>(z); }

  static void destroy(Plan p) { fftwf_destroy_plan(p); }

  static Plan plan_real_row(int n, float* row, Complex* out) {
    return fftwf_plan_dft_r2c_1d(n, row, raw(out), FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
  }
  static Plan plan_real_row_back(int n, Complex* in, float* row) {
    return fftwf_plan_dft_c2r_1d(n, raw(in), row, FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
  }
  static Plan plan_rows(int n, int rows, int stride, Complex* z, int sign) {
    return fftwf_plan_many_dft(1, &n, rows, raw(z), nullptr, 1, stride, raw(z), nullptr, 1, stride, sign,
                               FFTW_ESTIMATE);
  }

  static void execute_real_row(Plan p, float* row, Complex* out) { fftwf_execute_dft_r2c(p, row, raw(out)); }
  static void execute_real_row_back(Plan p, Complex* in, float* row) {
    fftwf_execute_dft_c2r(p, raw(in), row);
  }
  static void execute_rows(Plan p, Complex* z) { fftwf_execute_dft(p, raw(z), raw(z)); }
};

}  // namespace softwall::pressure
