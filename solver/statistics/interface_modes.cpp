#include "solver/statistics/interface_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "solver/case/time_comparison.hpp"
#include "solver/parallel/reduce.hpp"

namespace softwall::statistics {

namespace {

constexpr int kMostModes = 8;

}  // namespace

InterfaceModes::InterfaceModes(const grid::Grid& g)
    : modes_(static_cast<std::size_t>(std::min(kMostModes, g.nx_global / 2))) {}

bool InterfaceModes::is_due(const time::State& s, double dt) {
  return intervals_passed(s.time, kInterval) > intervals_passed(s.time - dt, kInterval);
}

void InterfaceModes::add(const time::State& s, std::span<const double> heights, const time::Setup& setup) {
  const auto& g = setup.grid;
  std::vector<double> row(row_length());
  const auto nx = static_cast<std::size_t>(g.nx);
  for (std::size_t i = 0; i < nx; ++i) {
    double line = 0;  // less the height at rest, whose modes are 0 but for round-off
    for (std::size_t n = i; n < heights.size(); n += nx) line += heights[n] - g.y_face[g.ny_fluid];
    const double x = (g.x_begin + double(i) + 0.5) / g.nx_global;
    for (std::size_t m = 1; m <= modes_; ++m) {
      const double phase = -2 * std::numbers::pi * double(m) * x;
      row[2 * m - 1] += line * std::cos(phase);
      row[2 * m] += line * std::sin(phase);
    }
  }
  parallel::sum(setup.decomposition.all(), row);
  for (double& value : row) value /= double(g.nx_global) * g.nz_global;
  row[0] = s.time;
  rows_.insert(rows_.end(), row.begin(), row.end());
}

void InterfaceModes::unpack(std::span<const double> packed) {
  if (packed.size() % row_length() != 0)
    throw std::runtime_error("waves of the interface in a checkpoint belong to another grid");
  rows_.assign(packed.begin(), packed.end());
}

}  // namespace softwall::statistics
