#pragma once

#include <vector>

#include "solver/grid/field.hpp"
#include "solver/grid/grid.hpp"
#include "solver/parallel/decomposition.hpp"
#include "solver/solid/material.hpp"

/// The interface as a height over each column (x, z): that of the material surface where the solid has one,
/// else from the depth of the solid, which moves as the material does wherever phi is smeared about it. (An
/// isoline of phi, linear between centers, moves half as far while the interface is still a step.)
namespace softwall::statistics {

/// Where phi, followed from the upper wall down each column, first falls below `level`: row as a real number,
/// j at y_center[j], interpolated linearly between the two centers around it. One value for each of this
/// rank's columns, i + nx k. -1/2 (the bottom wall) where phi never falls below, ny - 1/2 (the upper wall)
/// where it is below from the start. Islands of solid or fluid beyond the first crossing do not matter.
[[nodiscard]] std::vector<double> crossing_rows(const grid::Field& phi, double level, const grid::Grid& grid);

/// The interface of the whole plane at one moment, h.
struct InterfaceShape {
  double mean = 0;
  double rms = 0;            ///< about the mean
  double max_deviation = 0;  ///< max |eta - mean|
};

/// Height at which each column would end if what hangs from its upper wall were solid throughout, h: upper
/// wall - sum of phi dy, from the wall down to the first row with phi < 0.02, that one included. Solid below
/// that row is dust, a drop or the crest of a wave that has folded, and does not count. Where phi is the
/// exact share of each cell this is the surface's mean height over the column. Order as crossing_rows.
[[nodiscard]] std::vector<double> heights_of_solid(const grid::Field& phi, const grid::Grid& grid);

/// Height of the interface over each column, h: with a reference map that of the material surface over the
/// column's center, otherwise heights_of_solid. (phi of a reference map is measured under a surface that is
/// bilinear between columns. Its depths would miss 1 - (3 + cos(k dx)) / 4 of a wave: 1.9 % where it is 16
/// columns long, 7 % where it is 8.) Order as crossing_rows.
[[nodiscard]] std::vector<double> heights_of_interface(const solid::Material& material,
                                                       const grid::Grid& grid);

/// Mean, rms and largest deviation of the heights eta of this rank's columns. Collective.
[[nodiscard]] InterfaceShape shape_of(const std::vector<double>& eta, const grid::Grid& grid,
                                      const parallel::Decomposition& decomposition);

/// Distance in rows between phi = 0.9 and phi = 0.1, mean over all columns. A sharp step between two centers
/// counts 0.8. Collective.
[[nodiscard]] double interface_width(const grid::Field& phi, const grid::Grid& grid,
                                     const parallel::Decomposition& decomposition);

}  // namespace softwall::statistics
