#pragma once

#include "solver/case/case.hpp"
#include "solver/grid/field.hpp"

/// Rate of change of the displacement at a fixed point, from Dd/Dt = u:
///   dd_i/dt = u_i - u . grad(d_i)
/// d is smooth and no density, so nothing asks for flux form: the gradient is the upwind derivative of WENO5
/// for Hamilton-Jacobi equations (Jiang & Peng, SIAM J. Sci. Comput. 21, 2000), from the divided differences
/// of neighbours, so that a uniform gradient is exact on any grid.
namespace softwall::solid::reference_map {

using grid::Grid;
using grid::Real;
using grid::View;

/// Writes the rates in rows first_row <= j < ny (d_y: from max(first_row, 1)). Ghost cells of both must be
/// filled.
void find_rates(const grid::VectorField& displacement, const grid::VectorField& velocity, const Grid& grid,
                WenoWeights weights, int first_row, grid::VectorField& rate);

}  // namespace softwall::solid::reference_map
