#include "solver/statistics/closed_box/box_series.hpp"

#include <array>

#include "solver/statistics/closed_box/body.hpp"
#include "solver/statistics/solid_health.hpp"

namespace softwall::statistics {

namespace {

constexpr std::array<SeriesKind, 12> kBoxSeriesKinds = {{
    {"kinetic_energy", Combine::kMean, "rho U_b^2 h^2", "of the box, per depth"},
    {"elastic_energy", Combine::kMean, "rho U_b^2 h^2", "phi G (tr B - 3) / 2 of the box, per depth"},
    {"centroid_x", Combine::kMean, "h", "of the solid"},
    {"centroid_y", Combine::kMean, "h", "of the solid"},
    {"area", Combine::kMean, "h^2", "of the solid, sum of phi"},
    {"x_min", Combine::kMean, "h", "least x of the isoline phi = 1/2"},
    {"x_max", Combine::kMean, "h", "largest x of the isoline phi = 1/2"},
    {"y_min", Combine::kMean, "h", "least y of the isoline phi = 1/2"},
    {"y_max", Combine::kMean, "h", "largest y of the isoline phi = 1/2"},
    {"interface_width_cells", Combine::kMean, "cells", "10-90 % width of the solid fraction"},
    {"min_eigenvalue", Combine::kMinimum, "1", "smallest eigenvalue of B in the block"},
    {"max_det_error", Combine::kMaximum, "1", kDetErrorMeaning},
}};

}  // namespace

std::span<const SeriesKind> box_series_kinds(bool elastic) {
  return std::span(kBoxSeriesKinds).first(elastic ? kBoxSeriesKinds.size() : 1);
}

std::vector<double> box_series_sample(const time::State& s, const time::Setup& setup) {
  const BoxEnergy energy = energy_of(s, setup);
  if (!s.elastic) return {energy.kinetic};
  const Body body = body_of(s.material.phi, setup.grid, setup.decomposition);
  const SolidHealth health = solid_health(s, setup);
  return {energy.kinetic,
          energy.elastic,
          body.centroid_x,
          body.centroid_y,
          body.area,
          body.x_min,
          body.x_max,
          body.y_min,
          body.y_max,
          body.width_cells,
          health.min_eigenvalue,
          health.max_det_error};
}

}  // namespace softwall::statistics
