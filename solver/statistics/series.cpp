#include "solver/statistics/series.hpp"

#include <array>

#include "solver/statistics/interface_height.hpp"
#include "solver/statistics/solid_health.hpp"

namespace softwall::statistics {

namespace {

constexpr std::array<SeriesKind, 12> kSeriesKinds = {{
    {"wall_shear_bottom", Combine::kMean, "", ""},
    {"wall_shear_top", Combine::kMean, "", ""},
    {"bulk_velocity", Combine::kMean, "U_b", "mean streamwise velocity of the fluid"},
    {"interface_mean", Combine::kMean, "", ""},
    {"interface_rms", Combine::kMean, "", ""},
    {"interface_variance", Combine::kMean, "h^2", "plane variance of eta about its plane mean"},
    {"interface_max", Combine::kMean, "", ""},
    {"interface_peak", Combine::kMaximum, "", ""},
    {"min_eigenvalue", Combine::kMinimum, "1", "smallest eigenvalue of B in the block"},
    {"max_det_error", Combine::kMaximum, "1", kDetErrorMeaning},
    {"interface_width_cells", Combine::kMean, "cells", "10-90 % width of the solid fraction"},
    {"solid_volume", Combine::kMean, "h^3", "volume of the solid"},
}};
constexpr std::size_t kRigidCount = 3;

double bulk_velocity(const PlaneMeans& means, const time::State& s, const grid::Grid& g) {
  double flow = 0, volume = 0;
  for (int j = 0; j < g.ny; ++j) {
    flow += g.dy[j] * means(s.elastic ? kFluidU : kU, j);
    volume += g.dy[j] * (s.elastic ? 1 - means(kPhi, j) : 1.0);
  }
  return flow / volume;
}

}  // namespace

std::span<const SeriesKind> series_kinds(bool elastic) {
  return std::span(kSeriesKinds).first(elastic ? kSeriesKinds.size() : kRigidCount);
}

std::vector<double> series_sample(const time::State& s, const time::Setup& setup, const PlaneMeans& means) {
  const auto& g = setup.grid;
  std::vector<double> values = {means(kViscousStress, 0), -means(kViscousStress, g.ny),
                                bulk_velocity(means, s, g)};
  if (!s.elastic) return values;
  const InterfaceShape eta = shape_of(heights_of_interface(s.material, g), g, setup.decomposition);
  const SolidHealth health = solid_health(s, setup);
  values.insert(values.end(), {eta.mean, eta.rms, eta.rms * eta.rms, eta.max_deviation, eta.max_deviation,
                               health.min_eigenvalue, health.max_det_error, health.interface_width_cells,
                               health.solid_volume});
  return values;
}

}  // namespace softwall::statistics
