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

  /// One row of n complex numbers, from one place to another.
  static Plan plan_row(int n, Complex* from, Complex* to, int sign) {
    return fftw_plan_dft_1d(n, raw(from), raw(to), sign, FFTW_ESTIMATE);
  }
  /// `rows` rows of n complex numbers, `stride` apart, in place.
  static Plan plan_rows(int n, int rows, int stride, Complex* z, int sign) {
    return fftw_plan_many_dft(1, &n, rows, raw(z), nullptr, 1, stride, raw(z), nullptr, 1, stride, sign,
                              FFTW_ESTIMATE);
  }

  static void execute_row(Plan p, Complex* from, Complex* to) { fftw_execute_dft(p, raw(from), raw(to)); }
  static void execute_rows(Plan p, Complex* z) { fftw_execute_dft(p, raw(z), raw(z)); }
};

template <>
struct Fftw<float> {
  using Complex = std::complex<float>;
  using Plan = fftwf_plan;
  static fftwf_complex* raw(Complex* z) { return reinterpret_cast<fftwf_complex*>(z); }

  static void destroy(Plan p) { fftwf_destroy_plan(p); }

  static Plan plan_row(int n, Complex* from, Complex* to, int sign) {
    return fftwf_plan_dft_1d(n, raw(from), raw(to), sign, FFTW_ESTIMATE);
  }
  static Plan plan_rows(int n, int rows, int stride, Complex* z, int sign) {
    return fftwf_plan_many_dft(1, &n, rows, raw(z), nullptr, 1, stride, raw(z), nullptr, 1, stride, sign,
                               FFTW_ESTIMATE);
  }

  static void execute_row(Plan p, Complex* from, Complex* to) { fftwf_execute_dft(p, raw(from), raw(to)); }
  static void execute_rows(Plan p, Complex* z) { fftwf_execute_dft(p, raw(z), raw(z)); }
};

}  // namespace softwall::pressure
