#include "analysis/stress_balance.hpp"

#include <cmath>
#include <limits>

#include "analysis/block_means.hpp"

namespace softwall::analysis {
namespace {

bool has_face_profile(const BlockStatistics& s, const std::string& name) {
  const auto found = s.profiles.find(name);
  return found != s.profiles.end() && found->second.location == Location::kFace;
}

}  // namespace

std::vector<double> total_stress(const BlockStatistics& s, const std::vector<double>& weights) {
  const bool has_elastic = has_face_profile(s, "elastic_stress");
  if (!has_face_profile(s, "viscous_stress") || !has_face_profile(s, "uv") || (s.elastic && !has_elastic)) {
    return {};
  }
  std::vector<double> stress = mean_profile(s, "viscous_stress", weights);
  const std::vector<double> flux = mean_profile(s, "uv", weights);
  for (std::size_t j = 0; j < stress.size(); ++j) stress[j] -= flux[j];
  if (has_elastic) {
    const std::vector<double> elastic = mean_profile(s, "elastic_stress", weights);
    for (std::size_t j = 0; j < stress.size(); ++j) stress[j] += elastic[j];
  }
  return stress;
}

double stress_balance_residual(const BlockStatistics& s, const std::vector<double>& weights) {
  const std::vector<double> stress = total_stress(s, weights);
  if (stress.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double wall = mean_series(s, "wall_shear_bottom", weights);
  const double gradient = mean_series(s, "driving_gradient", weights);
  const auto squared_error = [&](std::size_t j) {
    const double error = stress[j] - (wall - gradient * s.y_face[j]);
    return error * error;
  };
  double integral = 0.0;  // trapezoids, so that fine cells do not count double
  for (std::size_t j = 0; j + 1 < stress.size(); ++j) {
    integral += 0.5 * (squared_error(j) + squared_error(j + 1)) * (s.y_face[j + 1] - s.y_face[j]);
  }
  return std::sqrt(integral / s.y_face.back()) / wall;
}

}  // namespace softwall::analysis
