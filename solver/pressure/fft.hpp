#pragma once

#include <complex>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include <fftw3.h>

/// Owners of FFTW plans and memory. Plans are estimated, not measured: a measured plan may differ from run to
/// run and with it the last bits of the result, and a restarted run must repeat an uninterrupted one bit for
/// bit.
namespace softwall::pressure {

using Complex = std::complex<double>;

/// FFTW-aligned array.
template <class T>
class Aligned {
 public:
  explicit Aligned(std::size_t n) : size_(n), data_(static_cast<T*>(fftw_malloc((n + 1) * sizeof(T)))) {
    if (!data_) throw std::bad_alloc();
    std::uninitialized_fill_n(data_.get(), n, T{});
  }
  [[nodiscard]] T* data() { return data_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  struct Free {
    void operator()(T* p) const { fftw_free(p); }
  };
  std::size_t size_;
  std::unique_ptr<T[], Free> data_;
};

/// One planned transform; executes on the arrays it was planned for. A default plan does nothing (a rank
/// without modes).
class Plan {
 public:
  Plan() = default;
  explicit Plan(fftw_plan plan) : plan_(plan) {
    if (!plan_) throw std::runtime_error("FFTW cannot plan this transform");
  }
  void execute() const {
    if (plan_) fftw_execute(plan_.get());
  }

 private:
  struct Destroy {
    void operator()(fftw_plan p) const { fftw_destroy_plan(p); }
  };
  std::unique_ptr<std::remove_pointer_t<fftw_plan>, Destroy> plan_;
};

/// `rows` consecutive real rows of length n <-> rows of n/2 + 1 complex coefficients.
[[nodiscard]] Plan plan_real_to_complex(int n, int rows, double* real, Complex* complex);
[[nodiscard]] Plan plan_complex_to_real(int n, int rows, Complex* complex, double* real);

/// In place along the slowest axis: `columns` interleaved sequences of length n, element m of each at stride
/// `columns`. sign: FFTW_FORWARD or FFTW_BACKWARD.
[[nodiscard]] Plan plan_columns(int n, int columns, Complex* data, int sign);

}  // namespace softwall::pressure
