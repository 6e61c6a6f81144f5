#pragma once

#include <span>
#include <vector>

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
  /// return the interior is divergence-free. The velocity's ghost cells beside it in x are right, its others
  /// stale; those of the pressure that gradients read (low x, low z) are right if they were so before.
  void project(grid::VectorField& velocity, grid::Field& pressure, const Stage& stage, double dt) {
    const double duration = 2 * stage.alpha * dt;
    find_psi(velocity, duration);
    correct(velocity, pressure, duration, 0);
  }

  /// A projection in two steps, duration = 2 alpha dt. Between them one can find what a uniform force has to
  /// add to u, `push` in U_b, which the correction adds in the same sweep.
  void find_psi(grid::VectorField& velocity, double duration);
  void correct(grid::VectorField& velocity, grid::Field& pressure, double duration, double push);

  /// psi of the last find_psi(), ghost cells at low x and low z filled.
  [[nodiscard]] const grid::Field& psi() const { return psi_; }
  /// Sums of its u* over this rank's cells of each row.
  [[nodiscard]] std::span<const double> row_sums() const { return row_sums_; }
  /// Its Fourier transforms, for statistics.
  [[nodiscard]] Poisson& poisson() { return poisson_; }

 private:
  const Grid& grid_;
  grid::Halo& halo_;
  parallel::Profile* profile_;
  Poisson poisson_;
  grid::Field psi_;
  std::vector<double> row_sums_;
};

/// Divergence of a velocity at centers.
struct Divergence {
  grid::View<const Real> u, v, w;
  Real inv_dx, inv_dz;
  Divergence(const grid::VectorField& velocity, const Grid& g)
      : u(velocity.x.view()),
        v(velocity.y.view()),
        w(velocity.z.view()),
        inv_dx(Real(1 / g.dx)),
        inv_dz(Real(1 / g.dz)) {}
  /// In a cell of row j, of which inv_dy is 1 over the height.
  [[nodiscard]] Real at(int i, int j, int k, Real inv_dy) const {
    return (u(i + 1, j, k) - u(i, j, k)) * inv_dx + (v(i, j + 1, k) - v(i, j, k)) * inv_dy +
           (w(i, j, k + 1) - w(i, j, k)) * inv_dz;
  }
};

/// Largest |div u| over all ranks, in U_b / h; ghost cells must be filled.
[[nodiscard]] double max_divergence(const grid::VectorField& velocity, const Grid& grid,
                                    const parallel::Decomposition& decomposition);

}  // namespace softwall::pressure
