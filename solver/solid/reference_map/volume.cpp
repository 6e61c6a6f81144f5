#include "solver/solid/reference_map/volume.hpp"

#include <algorithm>

namespace softwall::solid::reference_map {

namespace {

/// K_i dt / spacing^2 at most: three directions together stay within the reach of the Runge-Kutta scheme on
/// the negative real axis, 4 (K_x dt / dx^2 + ...) < 2.51.
constexpr double kMostInAStep = 0.15;

Real speed(double dt, double spacing) { return Real(std::min(1.0, kMostInAStep * spacing / dt)); }

}  // namespace

RelaxationSpeeds::RelaxationSpeeds(const Grid& grid) : grid_(grid), y_(static_cast<std::size_t>(grid.ny)) {}

void RelaxationSpeeds::set(double dt) {
  x_ = speed(dt, grid_.dx);
  z_ = speed(dt, grid_.dz);
  for (int j = 0; j < grid_.ny; ++j) y_[static_cast<std::size_t>(j)] = speed(dt, grid_.dy_face[j]);
}

}  // namespace softwall::solid::reference_map
