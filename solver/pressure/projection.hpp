#pragma once

#include "solver/grid/halo.hpp"
#include "solver/grid/stage.hpp"
#include "solver/pressure/poisson.hpp"

/// Makes the predicted velocity divergence-free and updates the pressure, paper eq:NS-num2 and eq:NS-num3:
///   laplacian(psi) = div(u*) / (2 alpha dt),   u = u* - 2 alpha dt grad psi,   p += psi.
namespace softwall::pressure {

class Projection {
 public:
  Projection(const Grid& grid, const parallel::Decomposition& decomposition, grid::Halo& halo,
             parallel::Profile* profile = nullptr);

  /// On entry the wall-normal velocity stands on the walls (rows 0 and ny), no other ghost cell matters. On
  /// return the interior is divergence-free; the velocity's ghost cells are stale, those of the pressure that
  /// gradients read (low x, low z) right if they were so before.
  void project(grid::VectorField& velocity, grid::Field& pressure, const Stage& stage, double dt);

 private:
  void find_psi(grid::VectorField& velocity, double duration);
  void correct(grid::VectorField& velocity, grid::Field& pressure, double duration);

  const Grid& grid_;
  grid::Halo& halo_;
  parallel::Profile* profile_;
  Poisson poisson_;
  grid::Field psi_;
};

/// Divergence at the center of cell (i, j, k).
inline Real divergence(const grid::View<const Real>& u, const grid::View<const Real>& v,
                       const grid::View<const Real>& w, Real inv_dx, Real inv_dy, Real inv_dz, int i, int j,
                       int k) {
  return (u(i + 1, j, k) - u(i, j, k)) * inv_dx + (v(i, j + 1, k) - v(i, j, k)) * inv_dy +
         (w(i, j, k + 1) - w(i, j, k)) * inv_dz;
}

/// Largest |div u| over all ranks, in U_b / h; ghost cells must be filled.
[[nodiscard]] double max_divergence(const grid::VectorField& velocity, const Grid& grid,
                                    const parallel::Decomposition& decomposition);

}  // namespace softwall::pressure
