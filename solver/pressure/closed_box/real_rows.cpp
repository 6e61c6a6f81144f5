#include "solver/pressure/closed_box/real_rows.hpp"

#include <stdexcept>
#include <vector>

namespace softwall::pressure {

RealRows::RealRows(const Shape& shape, fftw_r2r_kind forward, fftw_r2r_kind backward)
    : forward_(plan(shape, forward)), backward_(plan(shape, backward)) {}

RealRows::Owner RealRows::plan(const Shape& s, fftw_r2r_kind kind) {
  if (s.rows == 0) return {};
  std::vector<double> sample(static_cast<std::size_t>(s.rows) * static_cast<std::size_t>(s.distance));
  Owner made(fftw_plan_many_r2r(1, &s.n, s.rows, sample.data(), nullptr, 1, s.distance, sample.data(),
                                nullptr, 1, s.distance, &kind, FFTW_ESTIMATE | FFTW_UNALIGNED));
  if (!made) throw std::runtime_error("FFTW cannot plan this transform");
  return made;
}

void RealRows::execute(const Owner& plan, double* first) {
  if (plan) fftw_execute_r2r(plan.get(), first, first);
}

}  // namespace softwall::pressure
