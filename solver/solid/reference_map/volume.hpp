#pragma once

#include "solver/grid/field.hpp"

/// Keeps the discrete map from changing volume. Transport and extrapolation make small errors of det A, which
/// nothing else would ever undo: the flow has no divergence and the stress knows no volume, so they would add
/// up, and with them the volume of the solid. They are let out through the surface by diffusion,
///   dd_i/dt = u_i - u . grad(d_i) - D_i d/dx_i (det A - 1),
/// which to first order in d is d(det A)/dt = sum_i d/dx_i [ D_i d/dx_i (det A) ]. D_i is U_b times the
/// spacing, the rate at which transport makes them, or what is stable if that is less. Where volume is kept,
/// nothing happens.
///
/// det A - 1 counts in full cells; outside them it is zero. Weighted with phi in partly filled cells instead
/// it drove waves of the surface: what stands there is extrapolated, and its errors go with phi.
namespace softwall::solid::reference_map {

using grid::Grid;
using grid::Real;

/// Adds the last term to the rates of the displacement in rows from first_row on. phi and det A at centers,
/// with one column more on every side.
void relax_volume(const grid::Field& phi, const grid::Field& determinant, const Grid& grid, double dt,
                  int first_row, grid::VectorField& rate);

}  // namespace softwall::solid::reference_map
