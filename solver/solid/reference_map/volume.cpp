#include "solver/solid/reference_map/volume.hpp"

#include <algorithm>

namespace softwall::solid::reference_map {

namespace {

/// K_i dt / spacing^2 at most: three directions together stay within the reach of the Runge-Kutta scheme on
/// the negative real axis, 4 (K_x dt / dx^2 + ...) < 2.51.
constexpr double kMostInAStep = 0.15;

/// The time within which the volume of the whole solid is restored, h/U_b.
constexpr double kRestoringTime = 0.05;
/// The most of its relative change that is restored in a unit of time, U_b/h.
constexpr double kFastestRestoring = 0.1;

Real speed(double dt, double spacing) { return Real(std::min(1.0, kMostInAStep * spacing / dt)); }

}  // namespace

RelaxationSpeeds::RelaxationSpeeds(const Grid& grid)
    : grid_(grid), y_(static_cast<std::size_t>(grid.ny)), even_(y_.size()) {}

void RelaxationSpeeds::set(double dt) {
  x_ = speed(dt, grid_.dx);
  z_ = speed(dt, grid_.dz);
  for (int j = 0; j < grid_.ny; ++j) y_[static_cast<std::size_t>(j)] = speed(dt, grid_.dy_face[j]);
}

void RelaxationSpeeds::restore_volume(double dt, double at_rest, double excess) {
  const double wall = grid_.y_face[grid_.ny], most = kFastestRestoring * (wall - at_rest),
               rate = std::clamp(excess / std::max(kRestoringTime, dt), -most, most);
  for (int j = 0; j < grid_.ny; ++j)
    even_[static_cast<std::size_t>(j)] = Real(rate * (wall - grid_.y_face[j]) / (wall - at_rest));
}

}  // namespace softwall::solid::reference_map
