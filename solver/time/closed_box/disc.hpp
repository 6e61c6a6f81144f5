#pragma once

#include "solver/case/case.hpp"
#include "solver/solid/material.hpp"

namespace softwall::time {

/// Part of the cell 0 <= x - x_low <= dx, 0 <= y - y_low <= dy that lies in the disc: the length of each
/// horizontal chord is exact, the integral over y is the midpoint rule on 64 chords.
[[nodiscard]] double disc_fraction(const DiscSpec& disc, double x_low, double y_low, double dx, double dy);

/// A disc at rest (a cylinder along z): phi the fraction of each cell in it, B = identity everywhere.
[[nodiscard]] solid::Material disc_at_rest(const DiscSpec& disc, const grid::Grid& grid);

}  // namespace softwall::time
