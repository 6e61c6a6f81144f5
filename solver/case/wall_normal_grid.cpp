#include "solver/case/wall_normal_grid.hpp"

#include <cmath>
#include <cstdio>

namespace softwall {
namespace {

constexpr int kLeastLayerCells = 4, kMostLayerCells = 100000;

double fluid_face(const GridSpec& grid, int j) {
  if (j == 0) return 0.0;
  if (j == grid.ny_fluid) return kFluidHeight;
  const double s = grid.stretching;
  if (s == 0.0) return kFluidHeight * j / grid.ny_fluid;
  return 1.0 + std::tanh(s * (2.0 * j / grid.ny_fluid - 1.0)) / std::tanh(s);
}

double last_fluid_spacing(const GridSpec& grid) { return kFluidHeight - fluid_face(grid, grid.ny_fluid - 1); }

/// r + r^2 + ... + r^cells
double geometric_sum(double r, int cells) {
  if (std::abs(r - 1.0) < 1e-12) return cells;
  return r * std::expm1(cells * std::log(r)) / (r - 1.0);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string uniform_problem(const GridSpec& grid, double layer_height) {
  const double fluid = kFluidHeight / grid.ny_fluid, layer = layer_height / grid.ny_solid;
  if (std::abs(fluid - layer) <= 1e-9 * fluid) return "";
  const double cells = layer_height / fluid;
  std::string advice = "; no ny_solid fits this ny_fluid: layer_height * ny_fluid / 2 must be a whole number";
  if (cells < kLeastLayerCells * (1 - 1e-9))
    advice = "; for the " + std::to_string(kLeastLayerCells) +
             " cells that a layer needs, ny_fluid must be " +
             number(std::ceil(kLeastLayerCells * kFluidHeight / layer_height)) + " or more";
  else if (std::abs(cells - std::round(cells)) <= 1e-9 * cells)
    advice = "; ny_solid must be " + std::to_string(std::lround(cells));
  return "on a uniform grid the spacing in the layer (" + number(layer) + ") must equal that in the fluid (" +
         number(fluid) + ")" + advice;
}

/// Growth and spacings fall as cells are added: past this the layer has too many.
bool too_many_cells(double spacing, double layer_height, int cells) {
  const double growth = layer_growth(spacing, layer_height, cells);
  return growth < kLeastGrowth || std::pow(growth, cells) < kLeastSpacingRatio;
}

bool too_few_cells(double spacing, double layer_height, int cells) {
  return layer_growth(spacing, layer_height, cells) > kMostGrowth;
}

/// Smallest count of cells for which `holds`, which holds for all larger ones too.
template <typename Predicate>
int first_count(Predicate holds) {
  int low = kLeastLayerCells - 1, high = kMostLayerCells + 1;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (holds(middle) ? high : low) = middle;
  }
  return high;
}

std::string stretched_problem(const GridSpec& grid, double layer_height) {
  const double spacing = last_fluid_spacing(grid);
  const bool few = too_few_cells(spacing, layer_height, grid.ny_solid);
  if (!few && !too_many_cells(spacing, layer_height, grid.ny_solid)) return "";
  const int least = first_count([&](int cells) { return !too_few_cells(spacing, layer_height, cells); });
  const int most = first_count([&](int cells) { return too_many_cells(spacing, layer_height, cells); }) - 1;
  const std::string works =
      "ny_solid from " + std::to_string(least) + " to " + std::to_string(most) + " works";
  return std::string("too ") + (few ? "few" : "many") + " cells for a smooth spacing across the interface; " +
         (least <= most ? works : "none works: use other stretching or cells in the fluid");
}

}  // namespace

double layer_growth(double last_spacing, double layer_height, int cells) {
  const double wanted = layer_height / last_spacing;
  double low = 0.0, high = 1.0;
  while (geometric_sum(high, cells) < wanted) high *= 2.0;
  for (;;) {  // until no double lies between: the grid is then the same wherever it is computed
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return high;
    (geometric_sum(middle, cells) < wanted ? low : high) = middle;
  }
}

std::vector<double> wall_normal_faces(const GridSpec& grid, double layer_height) {
  std::vector<double> faces;
  faces.reserve(static_cast<std::size_t>(grid.ny()) + 1);
  for (int j = 0; j <= grid.ny_fluid; ++j) faces.push_back(fluid_face(grid, j));
  if (grid.ny_solid == 0) return faces;

  const bool uniform = grid.stretching == 0.0;
  double spacing = last_fluid_spacing(grid);
  const double growth = uniform ? 1.0 : layer_growth(spacing, layer_height, grid.ny_solid);
  for (int k = 1; k < grid.ny_solid; ++k) {
    spacing *= growth;
    faces.push_back(uniform ? kFluidHeight + layer_height * k / grid.ny_solid : faces.back() + spacing);
  }
  faces.push_back(kFluidHeight + layer_height);
  return faces;
}

std::vector<double> wall_normal_faces(const Physics& physics) {
  const GridSpec& grid = physics.grid;
  if (!is_closed_box(physics.flow)) return wall_normal_faces(grid, physics.layer_height);
  std::vector<double> faces;
  for (int j = 0; j <= grid.ny(); ++j) faces.push_back(physics.height * j / grid.ny());
  return faces;
}

std::string interface_spacing_problem(const GridSpec& grid, double layer_height) {
  return grid.stretching == 0.0 ? uniform_problem(grid, layer_height) : stretched_problem(grid, layer_height);
}

}  // namespace softwall
