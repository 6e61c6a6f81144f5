#include "solver/case/linear_equations.hpp"

#include <gtest/gtest.h>

namespace softwall {
namespace {

using Complex = std::complex<double>;

TEST(LinearEquations, AreSolved) {
  const std::vector<std::vector<Complex>> a{{0, {0, 2}, 1}, {{1, -1}, 4, 0}, {3, 0, {0, 5}}};  // needs a swap
  const std::vector<Complex> x{{1, 2}, -3, {0.5, -0.25}};
  std::vector<Complex> b(3);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) b[r] += a[r][c] * x[c];
  }
  const auto found = solve(a, b);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_LT(std::abs(found[n] - x[n]), 1e-14) << n;
}

TEST(LinearEquations, WithoutASolutionAreRefused) {
  EXPECT_THROW(static_cast<void>(solve<double>({{1, 2}, {2, 4}}, {1, 1})), std::domain_error);
}

}  // namespace
}  // namespace softwall
