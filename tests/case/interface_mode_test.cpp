#include "solver/case/interface_mode.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace softwall {
namespace {

using Complex = InterfaceMode::Complex;

struct Row {
  WaveLayers layers;
  Complex rate;
};

/// Rows of the reference file, scaled to a fluid 2 deep: lengths and times twice the file's, velocities the
/// same.
std::vector<Row> reference_rows() {
  std::ifstream file(SOFTWALL_REFERENCE_DATA "/interface_modes_linear.csv");
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("verif,")) continue;
    std::istringstream cells(line.substr(line.find(',') + 1));
    std::array<double, 9> value{};  // Hf, Hs, nu_f, nu_s, G_over_rho, lambda, mode, re_s, im_s
    char comma = 0;
    for (double& v : value) cells >> v >> comma;
    const auto [depth, thickness, nu_f, nu_s, G, length, mode, re, im] = value;
    static_cast<void>(mode);
    const double scale = 2 / depth;
    rows.push_back({wave_layers(1 / (nu_f * scale), length * scale, thickness * scale, G, nu_s / nu_f),
                    Complex(re, im) / scale});
  }
  return rows;
}

TEST(NearestRate, FindsEveryRowOfTheReference) {
  const auto rows = reference_rows();
  ASSERT_EQ(rows.size(), 10U);
  for (const Row& row : rows) {
    for (const double off : {0.0, 1e-3, 0.03}) {
      const auto found = nearest_rate(row.layers, row.rate * Complex(1 + off, -off));
      ASSERT_TRUE(found) << row.rate;
      EXPECT_LT(std::abs(*found - row.rate), 1e-9 * std::abs(row.rate)) << row.rate << " from " << off;
    }
  }
}

TEST(NearestRate, MayFindNone) {
  EXPECT_FALSE(nearest_rate(wave_layers(1e-300, 6, 0.5, 1, 1), {-1, 1}));
  EXPECT_FALSE(nearest_rate(wave_layers(2800, 1e-300, 0.5, 1, 1), {-1, 1}));
}

/// N (v'' + k^2 v) and -p + 2 N v' on one side of the interface.
std::array<Complex, 2> stresses(const Row& row, const InterfaceMode& mode, bool solid) {
  const WaveLayers& l = row.layers;
  const double k2 = l.k * l.k, y = solid ? l.depth * (1 + 1e-15) : l.depth;
  const Complex s = row.rate, N = solid ? l.nu_s + l.G / s : Complex(l.nu_f);
  const Complex p = (N * (mode.v(y, 3) - k2 * mode.v(y, 1)) - s * mode.v(y, 1)) / k2;
  return {N * (mode.v(y, 2) + k2 * mode.v(y)), -p + 2.0 * N * mode.v(y, 1)};
}

TEST(InterfaceMode, MeetsEveryConditionOfTheory) {
  for (const Row& row : reference_rows()) {
    const WaveLayers& l = row.layers;
    const InterfaceMode mode(l, row.rate);
    const double size = std::abs(mode.v(l.depth)), top = l.depth + l.thickness, above = l.depth * (1 + 1e-15);
    ASSERT_GT(size, 0);
    for (const int order : {0, 1}) {
      const double scale = size * std::pow(l.k, order);
      EXPECT_LT(std::abs(mode.v(0, order)), 1e-7 * scale);
      EXPECT_LT(std::abs(mode.v(top, order)), 1e-7 * scale);
      EXPECT_LT(std::abs(mode.v(l.depth, order) - mode.v(above, order)), 1e-7 * scale);
    }
    const auto in_fluid = stresses(row, mode, false), in_solid = stresses(row, mode, true);
    const double scale = l.G / std::abs(row.rate) * size * l.k * l.k;
    for (const std::size_t n : {0, 1}) EXPECT_LT(std::abs(in_fluid[n] - in_solid[n]), 1e-6 * scale) << n;
  }
}

/// (D^2 - k^2)(D^2 - m^2) v = 0, the derivatives by differences of v itself.
TEST(InterfaceMode, SolvesTheEquationOfEachLayer) {
  const Row row = reference_rows().front();
  const WaveLayers& l = row.layers;
  const InterfaceMode mode(l, row.rate);
  for (const bool solid : {false, true}) {
    const double y = solid ? l.depth + l.thickness / 3 : l.depth / 3, h = 0.02;
    const Complex N = solid ? l.nu_s + l.G / row.rate : Complex(l.nu_f), m2 = l.k * l.k + row.rate / N;
    const auto helmholtz = [&](double at, Complex q2, const auto& f) {
      return (f(at + h) - 2.0 * f(at) + f(at - h)) / (h * h) - q2 * f(at);
    };
    const auto v = [&](double at) { return mode.v(at); };
    const auto inner = [&](double at) { return helmholtz(at, m2, v); };
    const Complex rest = helmholtz(y, l.k * l.k, inner);
    EXPECT_LT(std::abs(rest), 0.01 * std::abs(l.k * l.k * m2) * std::abs(mode.v(l.depth)));
    EXPECT_LT(std::abs(mode.v(y, 1) - (v(y + h) - v(y - h)) / (2 * h)),
              0.01 * l.k * std::abs(mode.v(l.depth)));
  }
}

}  // namespace
}  // namespace softwall
