#include "solver/pressure/fft.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/round_off.hpp"

namespace softwall::pressure {
namespace {

using Row = std::vector<Real>;
using Coefficients = std::vector<Complex>;

/// Numbers in (-1, 1) without any symmetry.
Row scattered(int n, double seed) {
  Row row;
  for (int i = 0; i < n; ++i) row.push_back(Real(std::sin(seed * (i + 1) * (i + 2))));
  return row;
}

/// Sum over i of row[i] exp(-2 pi I i m / n), as it is defined.
std::complex<double> coefficient(const Row& row, int m) {
  const int n = int(row.size());
  std::complex<double> sum = 0;
  for (int i = 0; i < n; ++i)
    sum += double(row[std::size_t(i)]) * std::polar(1.0, -2 * std::numbers::pi * ((i * m) % n) / n);
  return sum;
}

class PairOfRows : public testing::TestWithParam<int> {
 protected:
  const int n = GetParam();
  const double tolerance = support::round_off(4 * (1 + std::log2(n)) * std::sqrt(n));
  RealRowPairTransform transform{n};

  void expect_coefficients_of(const Row& row, const Coefficients& found) const {
    for (int m = 0; m <= n / 2; ++m) {
      EXPECT_LE(std::abs(std::complex<double>(found[std::size_t(m)]) - coefficient(row, m)), tolerance)
          << "mode " << m << " of " << n;
    }
  }
  void expect_n_times(const Row& row, const Row& found) const {
    for (std::size_t i = 0; i < row.size(); ++i) EXPECT_NEAR(found[i] / n, row[i], tolerance) << i;
  }
};

TEST_P(PairOfRows, HasTheCoefficientsOfEachRow) {
  const Row a = scattered(n, 0.7), b = scattered(n, 1.9);
  const auto modes = std::size_t(n) / 2 + 1;
  Coefficients a_hat(modes), b_hat(modes);
  transform.forward(a.data(), b.data(), a_hat.data(), b_hat.data());
  expect_coefficients_of(a, a_hat);
  expect_coefficients_of(b, b_hat);
  Row a_back(a.size()), b_back(b.size());
  transform.backward(a_hat.data(), b_hat.data(), a_back.data(), b_back.data());
  expect_n_times(a, a_back);
  expect_n_times(b, b_back);
}

TEST_P(PairOfRows, MayBeOneRowTwice) {
  const Row a = scattered(n, 0.7);
  Coefficients a_hat(std::size_t(n) / 2 + 1);
  transform.forward(a.data(), a.data(), a_hat.data(), a_hat.data());
  expect_coefficients_of(a, a_hat);
  Row first(a.size()), second(a.size());
  transform.backward(a_hat.data(), a_hat.data(), first.data(), second.data());
  expect_n_times(a, first);
  expect_n_times(a, second);
}

INSTANTIATE_TEST_SUITE_P(Lengths, PairOfRows, testing::Values(1, 2, 3, 8, 15, 96, 128));

}  // namespace
}  // namespace softwall::pressure
