#include "solver/solid/reference_map/volume.hpp"

#include <algorithm>

#include "solver/grid/cell_loop.hpp"

namespace softwall::solid::reference_map {

namespace {

/// D dt / spacing^2 at most: three directions together stay within the reach of the Runge-Kutta scheme on the
/// negative real axis, 4 (D_x dt / dx^2 + ...) < 2.51.
constexpr double kMostInAStep = 0.15;
/// Errors beyond it count as if they were this large: they belong to a map that is torn.
constexpr Real kLargestError = 0.5;

/// D / spacing, U_b.
Real speed(double dt, double spacing) { return Real(std::min(1.0, kMostInAStep * spacing / dt)); }

}  // namespace

void relax_volume(const grid::Field& phi, const grid::Field& determinant, const Grid& g, double dt,
                  int first_row, grid::VectorField& rate) {
  const auto f = phi.view(), J = determinant.view();
  const auto error = [=](int i, int j, int k) {
    const Real e = std::min(std::max(J(i, j, k) - 1, -kLargestError), kLargestError);
    return f(i, j, k) < 1 ? Real(0) : e;
  };
  const auto x = rate.x.view(), y = rate.y.view(), z = rate.z.view();
  const Real in_x = speed(dt, g.dx), in_z = speed(dt, g.dz);
  grid::for_each_cell(grid::rows(g, first_row, g.ny), [=](int i, int j, int k) {
    x(i, j, k) -= in_x * (error(i, j, k) - error(i - 1, j, k));
    z(i, j, k) -= in_z * (error(i, j, k) - error(i, j, k - 1));
  });
  const Real* spacing = g.dy_face.data();
  grid::for_each_cell(grid::rows(g, std::max(first_row, 1), g.ny), [=](int i, int j, int k) {
    y(i, j, k) -= speed(dt, spacing[j]) * (error(i, j, k) - error(i, j - 1, k));
  });
}

}  // namespace softwall::solid::reference_map
