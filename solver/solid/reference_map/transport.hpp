#pragma once

#include "solver/case/case.hpp"
#include "solver/grid/field.hpp"
#include "solver/solid/reference_map/volume.hpp"

/// Rate of change of the displacement at a fixed point, from Dd/Dt = u:
///   dd_i/dt = u_i - u . grad(d_i) - what relaxes volume (volume.hpp)
/// d is smooth and no density, so nothing asks for flux form: the gradient is the upwind derivative of WENO5
/// for Hamilton-Jacobi equations (Jiang & Peng, SIAM J. Sci. Comput. 21, 2000), from the divided differences
/// of neighbours, so that a uniform gradient is exact on any grid.
namespace softwall::solid::reference_map {

/// Rows j0 <= j < ny of plane k (d_y: from max(j0, 1)).
struct RowsOfAPlane {
  int k, j0;
};

/// Where the rates of a plane go; its number does not matter.
struct PlaneOfRates {
  View<Real> x, y, z;
};

/// Writes the rates in these rows. They read `displacement` up to three cells away; its ghost cells and the
/// velocity's must be filled.
void find_rates(const grid::VectorField& displacement, const grid::VectorField& velocity,
                const VolumeRelaxation& relaxation, const Grid& grid, WenoWeights weights,
                const RowsOfAPlane& rows, const PlaneOfRates& rates);

}  // namespace softwall::solid::reference_map
