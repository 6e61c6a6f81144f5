#include "solver/statistics/wave_series.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "solver/parallel/reduce.hpp"
#include "solver/statistics/interface_height.hpp"
#include "solver/statistics/solid_health.hpp"

namespace softwall::statistics {

namespace {

constexpr std::array<SeriesKind, 7> kKinds = {{
    {"time", Combine::kMean, "h/U_b", "of the samples in the block"},
    {"wave_v_fluid", Combine::kMean, "U_b", "cos(k x) part of v at half the depth of the fluid"},
    {"wave_v", Combine::kMean, "U_b", "cos(k x) part of v at the height of the flat interface"},
    {"wave_v_solid", Combine::kMean, "U_b", "cos(k x) part of v at half the height of the layer"},
    {"wave_height", Combine::kMean, "h", "cos(k x) part of the height of the interface"},
    {"min_eigenvalue", Combine::kMinimum, "1", "smallest eigenvalue of B in the block"},
    {"max_det_error", Combine::kMaximum, "1", "largest |det B - 1| in the solid in the block"},
}};

/// cos(k x) part of what stands at the centers of all columns, k of the longest wave: 2 / N sum q cos(k x).
/// Value: q(i, k) of this rank's columns.
template <class Value>
double cosine_part(const time::Setup& setup, const Value& value) {
  const auto& g = setup.grid;
  double sum = 0;
  for (int k = 0; k < g.nz; ++k) {
    for (int i = 0; i < g.nx; ++i)
      sum += value(i, k) * std::cos(2 * std::numbers::pi * (g.x_begin + i + 0.5) / g.nx_global);
  }
  return 2 * parallel::sum(setup.decomposition.all(), sum) / (double(g.nx_global) * g.nz_global);
}

double cosine_part_of_v(const time::State& s, const time::Setup& setup, int row) {
  return cosine_part(setup, [&](int i, int k) { return double(s.velocity.y(i, row, k)); });
}

double cosine_part_of_height(const time::State& s, const time::Setup& setup) {
  const auto heights = heights_of_solid(s.material.phi, setup.grid);
  return cosine_part(setup,
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
  return {s.time,
          cosine_part_of_v(s, setup, face_at(interface / 2, g)),
          cosine_part_of_v(s, setup, g.ny_fluid),
          cosine_part_of_v(s, setup, face_at((interface + g.height) / 2, g)),
          cosine_part_of_height(s, setup),
          health.min_eigenvalue,
          health.max_det_error};
}

}  // namespace softwall::statistics
