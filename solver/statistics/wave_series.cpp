#include "solver/statistics/wave_series.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "solver/parallel/reduce.hpp"
#include "solver/statistics/interface_height.hpp"
#include "solver/statistics/solid_health.hpp"

namespace softwall::statistics {

namespace {

constexpr std::array<SeriesKind, 11> kKinds = {{
    {"time", Combine::kMean, "h/U_b", "of the samples in the block"},
    {"wave_v_fluid", Combine::kMean, "U_b", "cos(k x) part of v at half the depth of the fluid"},
    {"wave_v", Combine::kMean, "U_b", "cos(k x) part of v at the height of the flat interface"},
    {"wave_v_solid", Combine::kMean, "U_b", "cos(k x) part of v at half the height of the layer"},
    {"wave_height", Combine::kMean, "h", "cos(k x) part of the height of the interface"},
    {"wave_v_fluid_sin", Combine::kMean, "U_b", "sin(k x) part of v at half the depth of the fluid"},
    {"wave_v_sin", Combine::kMean, "U_b", "sin(k x) part of v at the height of the flat interface"},
    {"wave_v_solid_sin", Combine::kMean, "U_b", "sin(k x) part of v at half the height of the layer"},
    {"wave_height_sin", Combine::kMean, "h", "sin(k x) part of the height of the interface"},
    {"min_eigenvalue", Combine::kMinimum, "1", "smallest eigenvalue of B in the block"},
    {"max_det_error", Combine::kMaximum, "1", kDetErrorMeaning},
}};

/// Parts of the longest wave in what stands at the centers of all columns: 2 / N sum q cos(k x), and of sin.
struct Parts {
  double cos, sin;
};

/// Value: q(i, k) of this rank's columns.
template <class Value>
Parts wave_parts(const time::Setup& setup, const Value& value) {
  const auto& g = setup.grid;
  std::array<double, 2> sums{};
  for (int k = 0; k < g.nz; ++k) {
    for (int i = 0; i < g.nx; ++i) {
      const double angle = 2 * std::numbers::pi * (g.x_begin + i + 0.5) / g.nx_global;
      sums[0] += value(i, k) * std::cos(angle);
      sums[1] += value(i, k) * std::sin(angle);
    }
  }
  parallel::sum(setup.decomposition.all(), sums);
  const double scale = 2 / (double(g.nx_global) * g.nz_global);
  return {scale * sums[0], scale * sums[1]};
}

Parts parts_of_v(const time::State& s, const time::Setup& setup, int row) {
  return wave_parts(setup, [&](int i, int k) { return double(s.velocity.y(i, row, k)); });
}

Parts parts_of_height(const time::State& s, const time::Setup& setup) {
  const auto heights = heights_of_interface(s.material, setup.grid);
  return wave_parts(setup,
                    [&](int i, int k) { return heights[static_cast<std::size_t>(i + setup.grid.nx * k)]; });
}

/// The y face nearest to a height.
int face_at(double y, const grid::Grid& g) {
  int row = 0;
  while (row < g.ny && g.y_center[row] < y) ++row;
  return row;
}

}  // namespace

std::span<const SeriesKind> wave_series_kinds() { return kKinds; }

std::vector<double> wave_series_sample(const time::State& s, const time::Setup& setup) {
  const auto& g = setup.grid;
  const double interface = g.y_face[g.ny_fluid];
  const SolidHealth health = solid_health(s, setup);
  const Parts in_fluid = parts_of_v(s, setup, face_at(interface / 2, g)),
              at_interface = parts_of_v(s, setup, g.ny_fluid),
              in_solid = parts_of_v(s, setup, face_at((interface + g.height) / 2, g)),
              height = parts_of_height(s, setup);
  return {s.time,     in_fluid.cos,          at_interface.cos,    in_solid.cos,
          height.cos, in_fluid.sin,          at_interface.sin,    in_solid.sin,
          height.sin, health.min_eigenvalue, health.max_det_error};
}

}  // namespace softwall::statistics
