#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/order.hpp"

namespace softwall::support {

/// "what: 0.1 0.025 0.006 (order 2.00 2.06)", for errors on grids (or time steps) each `ratio` times finer.
inline std::string described(const std::string& what, const std::vector<double>& errors, double ratio = 2) {
  const auto number = [](const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return std::string(text);
  };
  std::string text = what + ":";
  for (const double error : errors) text += number(" %.3g", error);
  text += " (order";
  for (std::size_t n = 1; n < errors.size(); ++n)
    text += number(" %.2f", observed_order(errors[n - 1], errors[n], ratio));
  return text + ")";
}

/// Prints what was measured, for the tables of tests/README.md.
inline void report(const std::string& what, const std::vector<double>& errors, double ratio = 2) {
  std::printf("[ measured ] %s\n", described(what, errors, ratio).c_str());
}

/// Expects an order of at least `least` between the two finest of three or more errors, and over all of them
/// hardly less; reports what was measured.
inline void expect_order(const std::string& what, const std::vector<double>& errors, double least,
                         double ratio = 2) {
  constexpr double kCoarseAllowance = 0.3;  // a coarse grid may be short of its asymptote
  const std::string measured = described(what, errors, ratio);
  report(what, errors, ratio);
  ASSERT_GE(errors.size(), 3U);
  EXPECT_GE(last_order(errors, ratio), least) << measured;
  const double overall = observed_order(errors.front(), errors.back(), ratio);
  EXPECT_GE(overall / static_cast<double>(errors.size() - 1), least - kCoarseAllowance) << measured;
}

/// The same for errors that fall below `floor`, where parts of different sign may cancel: expects the order
/// between the first grid with so small an error and the one before it, or else between the two finest.
inline void expect_order_down_to(double floor, const std::string& what, const std::vector<double>& errors,
                                 double least) {
  report(what, errors);
  ASSERT_GE(errors.size(), 3U);
  std::size_t n = 1;
  while (n + 1 < errors.size() && errors[n] >= floor) ++n;
  EXPECT_GE(observed_order(errors[n - 1], errors[n], 2.0), least) << described(what, errors);
}

}  // namespace softwall::support
