#include "solver/statistics/interface_height.hpp"

#include <algorithm>
#include <cmath>

#include "solver/parallel/reduce.hpp"
#include "solver/solid/reference_map/surface.hpp"

namespace softwall::statistics {

namespace {

/// Not yet crossed; no row is this low.
constexpr double kPending = -1e9;

/// One step down, from row j to j - 1, for the columns of one line in x. Returns how many still wait.
int step_down(const grid::Real* above, const grid::Real* below, double level, int j, int nx,
              double* crossing) {
  int pending = 0;
#pragma omp simd reduction(+ : pending)
  for (int i = 0; i < nx; ++i) {
    const bool waiting = crossing[i] == kPending, here = below[i] < level;
    const double fall = double(above[i]) - below[i];
    const double row = j - (above[i] - level) / (here ? fall : 1.0);
    crossing[i] = waiting && here ? row : crossing[i];
    pending += waiting && !here ? 1 : 0;
  }
  return pending;
}

}  // namespace

std::vector<double> crossing_rows(const grid::Field& field, double level, const grid::Grid& g) {
  const auto phi = field.view();
  const auto nx = static_cast<std::size_t>(g.nx);
  std::vector<double> rows(nx * static_cast<std::size_t>(g.nz), kPending);
  for (int k = 0; k < g.nz; ++k) {
    double* crossing = rows.data() + static_cast<std::size_t>(k) * nx;
    for (int i = 0; i < g.nx; ++i) {
      if (phi(i, g.ny - 1, k) < level) crossing[i] = g.ny - 0.5;
    }
    int pending = g.nx;
    for (int j = g.ny - 1; j > 0 && pending > 0; --j) {
      pending = step_down(&phi(0, j, k), &phi(0, j - 1, k), level, j, g.nx, crossing);
    }
  }
  std::replace(rows.begin(), rows.end(), kPending, -0.5);
  return rows;
}

std::vector<double> heights_of_solid(const grid::Field& field, const grid::Grid& g) {
  const auto phi = field.view();
  const auto nx = static_cast<std::size_t>(g.nx);
  std::vector<double> heights(nx * static_cast<std::size_t>(g.nz), g.y_face[g.ny]);
  std::vector<double> share(nx);  // of a row that counts: 1 down to the first row of dust, that one included
  for (int k = 0; k < g.nz; ++k) {
    double* height = heights.data() + static_cast<std::size_t>(k) * nx;
    std::fill(share.begin(), share.end(), 1.0);
    double left = double(g.nx);
    for (int j = g.ny - 1; j >= 0 && left > 0; --j) {
      const double dy = g.dy[j];
      left = 0;
#pragma omp simd reduction(+ : left)
      for (int i = 0; i < g.nx; ++i) {
        height[i] -= share[i] * phi(i, j, k) * dy;
        share[i] = phi(i, j, k) < solid::kDust ? 0 : share[i];
        left += share[i];
      }
    }
  }
  return heights;
}

std::vector<double> heights_of_interface(const solid::Material& material, const grid::Grid& g) {
  if (material.formulation != SolidFormulation::kReferenceMap) return heights_of_solid(material.phi, g);
  solid::reference_map::Heights surface(g, 0);
  surface.find(material.displacement.y, material.surface_at_rest);
  std::vector<double> heights;
  for (int k = 0; k < g.nz; ++k) heights.insert(heights.end(), surface.row(k), surface.row(k) + g.nx);
  return heights;
}

InterfaceShape shape_of(const std::vector<double>& eta, const grid::Grid& g,
                        const parallel::Decomposition& decomposition) {
  const auto& all = decomposition.all();
  const double columns = double(g.nx_global) * g.nz_global;
  InterfaceShape shape;
  double sum = 0;
  for (const double height : eta) sum += height;
  shape.mean = parallel::sum(all, sum) / columns;
  double squares = 0, top = 0;
  for (const double height : eta) {
    const double deviation = height - shape.mean;
    squares += deviation * deviation;
    top = std::max(top, std::abs(deviation));
  }
  shape.rms = std::sqrt(parallel::sum(all, squares) / columns);
  shape.max_deviation = parallel::maximum(all, top);
  return shape;
}

double interface_width(const grid::Field& phi, const grid::Grid& g,
                       const parallel::Decomposition& decomposition) {
  const std::vector<double> solid_side = crossing_rows(phi, 0.9, g), fluid_side = crossing_rows(phi, 0.1, g);
  double sum = 0;
  for (std::size_t n = 0; n < solid_side.size(); ++n) sum += solid_side[n] - fluid_side[n];
  return parallel::sum(decomposition.all(), sum) / (double(g.nx_global) * g.nz_global);
}

}  // namespace softwall::statistics
