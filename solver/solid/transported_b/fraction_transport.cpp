#include "solver/solid/transported_b/fraction_transport.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/transported_b/thinc.hpp"

namespace softwall::solid {

namespace {

using grid::View;

/// Less solid, or less fluid, than this is carried along as it is.
constexpr double kTrace = 1e-8;
/// A cell counts as flat when its gradient is a smaller part than this of the lesser of solid and fluid in
/// it.
constexpr double kFlat = 1e-3;

/// Differences of phi across cell (i, j, k): the mean over its corners, each the mean of four differences
/// across an edge there, times the size of the cell.
struct CornerGradient {
  View<const Real> phi;
  const Real *dy, *inv_dy_face;

  std::array<double, 3> operator()(int i, int j, int k) const {
    // Sums over planes of nine with the weights 1 2 1, from below j to above; x and z differences in them.
    std::array<double, 3> level{}, in_x{}, in_z{};
    for (int b = 0; b < 3; ++b) {
      const auto row = [&](int c) {
        const Real* q = &phi(i, j + b - 1, k + c);
        return std::array<double, 2>{double(q[-1]) + 2 * double(q[0]) + q[1], double(q[1]) - q[-1]};
      };
      const auto below = row(-1), here = row(0), above = row(1);
      level[b] = (below[0] + 2 * here[0] + above[0]) / 16;
      in_x[b] = (below[1] + 2 * here[1] + above[1]) / 8;
      in_z[b] = (above[0] - below[0]) / 8;
    }
    const auto mean = [](const std::array<double, 3>& q) { return (q[0] + 2 * q[1] + q[2]) / 4; };
    const double in_y =
        dy[j] * ((level[2] - level[1]) * inv_dy_face[j + 1] + (level[1] - level[0]) * inv_dy_face[j]) / 2;
    return {mean(in_x), in_y, mean(in_z)};
  }
};

bool any_mixed(const Real* row, int n) {
  int mixed = 0;
#pragma omp simd reduction(+ : mixed)
  for (int i = 0; i < n; ++i) mixed += row[i] > Real(kTrace) && 1 - row[i] > Real(kTrace) ? 1 : 0;
  return mixed > 0;
}

}  // namespace

FractionTransport::FractionTransport(const Grid& grid, grid::Halo& halo)
    : grid_(grid), update_(grid, halo), flux_(grid, 1) {}

void FractionTransport::advance(grid::Field& phi, const grid::VectorField& velocity, const Stage& stage,
                                double dt, int first_row) {
  carry_upwind(phi, velocity, first_row);
  carry_steps(phi, velocity, first_row);
  update_.advance(phi, flux_, velocity, stage, dt, first_row);
}

/// Finds the flux of phi that every cell carries unless it holds a step.
void FractionTransport::carry_upwind(const grid::Field& phi, const grid::VectorField& velocity,
                                     int first_row) {
  const auto q = phi.view();
  const auto u = velocity.x.view(), v = velocity.y.view(), w = velocity.z.view();
  const auto x = flux_.x.view(), y = flux_.y.view(), z = flux_.z.view();
  const int nx = grid_.nx, ny = grid_.ny, nz = grid_.nz;
  const auto upwind = [](Real speed, Real below, Real above) { return speed * (speed > 0 ? below : above); };
  grid::for_each_cell({0, nx + 1, first_row, ny, 0, nz}, [=](int i, int j, int k) {
    x(i, j, k) = upwind(u(i, j, k), q(i - 1, j, k), q(i, j, k));
  });
  grid::for_each_cell({0, nx, first_row + 1, ny, 0, nz}, [=](int i, int j, int k) {
    y(i, j, k) = upwind(v(i, j, k), q(i, j - 1, k), q(i, j, k));
  });
  grid::for_each_cell({0, nx, first_row, ny, 0, nz + 1}, [=](int i, int j, int k) {
    z(i, j, k) = upwind(w(i, j, k), q(i, j, k - 1), q(i, j, k));
  });
}

/// Each face has one upwind cell, so it is enough to go through the cells and write where something flows out
/// of them: to the neighbours, and from the ghost cells into this rank's own.
void FractionTransport::carry_steps(const grid::Field& phi, const grid::VectorField& velocity,
                                    int first_row) {
  const auto q = phi.view();
  const auto u = velocity.x.view(), v = velocity.y.view(), w = velocity.z.view();
  const auto x = flux_.x.view(), y = flux_.y.view(), z = flux_.z.view();
  const int nx = grid_.nx, ny = grid_.ny, nz = grid_.nz;
  const CornerGradient gradient_at{q, grid_.dy.data(), grid_.inv_dy_face.data()};
  const auto carry_out = [&](int i, int j, int k) {
    const double here = q(i, j, k), less = std::min(here, 1 - here);
    if (!(less > kTrace)) return;
    const auto gradient = gradient_at(i, j, k);
    if (std::hypot(gradient[0], gradient[1], gradient[2]) < kFlat * less) return;
    const Thinc step(here, gradient);
    const bool own_x = i >= 0 && i < nx, own_z = k >= 0 && k < nz;
    const auto out = [&](const View<Real>& flux, const View<const Real>& speed, int axis, bool high) {
      const int a = i + (axis == 0 && high), b = j + (axis == 1 && high), c = k + (axis == 2 && high);
      const Real carrier = speed(a, b, c);
      if (high ? carrier > 0 : carrier < 0) flux(a, b, c) = carrier * Real(step.on_face(axis, high));
    };
    if (own_z && i >= 0) out(x, u, 0, false);
    if (own_z && i < nx) out(x, u, 0, true);
    if (own_x && own_z && j > first_row) out(y, v, 1, false);
    if (own_x && own_z && j + 1 < ny) out(y, v, 1, true);
    if (own_x && k >= 0) out(z, w, 2, false);
    if (own_x && k < nz) out(z, w, 2, true);
  };
  for (int k = -1; k <= nz; ++k) {
    for (int j = first_row; j < ny; ++j) {
      if (!any_mixed(&q(-1, j, k), nx + 2)) continue;
      const bool ghost_row = k < 0 || k == nz;  // in the corners no face is this rank's
      for (int i = ghost_row ? 0 : -1; i < nx + (ghost_row ? 0 : 1); ++i) carry_out(i, j, k);
    }
  }
}

}  // namespace softwall::solid
