#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "solver/case/linear_equations.hpp"

namespace softwall::support {

using Complex = std::complex<double>;

/// The rate s of a decaying oscillation that several probes record at equal intervals, all of them
/// x_n = Re[ c exp(s n interval) ] with their own c: least squares of x_n = a x_{n-1} + b x_{n-2}, whose
/// roots are exp(+-s interval) (Prony's method). records[n]: what all probes read at time n.
inline Complex oscillation_rate(const std::vector<std::vector<double>>& records, double interval) {
  std::vector<std::vector<double>> normal(2, std::vector<double>(2, 0.0));
  std::vector<double> right(2, 0.0);
  for (std::size_t n = 2; n < records.size(); ++n) {
    for (std::size_t probe = 0; probe < records[n].size(); ++probe) {
      const double now = records[n][probe], before[2] = {records[n - 1][probe], records[n - 2][probe]};
      for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t b = 0; b < 2; ++b) normal[a][b] += before[a] * before[b];
        right[a] += before[a] * now;
      }
    }
  }
  const std::vector<double> x = solve(normal, right);
  return std::log((x[0] + std::sqrt(Complex(x[0] * x[0] + 4 * x[1]))) / 2.0) / interval;
}

}  // namespace softwall::support
