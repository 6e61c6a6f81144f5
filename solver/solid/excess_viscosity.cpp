#include "solver/solid/excess_viscosity.hpp"

#include <algorithm>
#include <array>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/column_extension.hpp"
#include "solver/solid/fraction.hpp"
#include "solver/solid/stress_work.hpp"

namespace softwall::solid {

namespace {

/// What the fluid's viscous stress lacks, where its components live.
struct ExcessStress {
  static constexpr bool kAcrossRowsOnly = false;
  Fraction phi;
  View<const Real> u, v, w;
  View<const Real> shear_xy, shear_yz;  ///< du/dy and dw/dy of the solid
  const Real *inv_dy, *inv_dy_face;
  Real inv_dx, inv_dz, ratio;
  InterfaceShareView share;
  Real excess() const { return ratio - 1; }
  /// What mu_f g lacks at an edge: (1 - s) g_f + s mu_s / mu_f g_s - g. `mixed`: d/dy across the edge,
  /// `solid`: of the solid, `along`: the other part of the shear, which both have; a: of interface_share.hpp.
  [[gnu::always_inline]] Real lacking(Real fraction, Real a, Real mixed, Real solid, Real along) const {
    const Real fluid = factor_of_fluid(fraction, a);
    return (fluid - 1) * (mixed + along) +
           (ratio * share_of_solid(fraction, a) - fluid * fraction) * (solid + along);
  }
  /// The parts of xy and yz that follow from differences between rows.
  [[gnu::always_inline]] Real xy_across(int i, int j, int k) const {
    return lacking(phi.edge_xy(i, j, k), share.xy(i, k), (u(i, j, k) - u(i, j - 1, k)) * inv_dy_face[j],
                   shear_xy(i, j, k), 0);
  }
  [[gnu::always_inline]] Real yz_across(int i, int j, int k) const {
    return lacking(phi.edge_yz(i, j, k), share.yz(i, k), (w(i, j, k) - w(i, j - 1, k)) * inv_dy_face[j],
                   shear_yz(i, j, k), 0);
  }
  [[gnu::always_inline]] Real xx(int i, int j, int k) const {
    return 2 * excess() * phi.center(i, j, k) * (u(i + 1, j, k) - u(i, j, k)) * inv_dx;
  }
  [[gnu::always_inline]] Real yy(int i, int j, int k) const {
    return 2 * excess() * phi.center(i, j, k) * (v(i, j + 1, k) - v(i, j, k)) * inv_dy[j];
  }
  [[gnu::always_inline]] Real zz(int i, int j, int k) const {
    return 2 * excess() * phi.center(i, j, k) * (w(i, j, k + 1) - w(i, j, k)) * inv_dz;
  }
  [[gnu::always_inline]] Real xy(int i, int j, int k) const {
    return lacking(phi.edge_xy(i, j, k), share.xy(i, k), (u(i, j, k) - u(i, j - 1, k)) * inv_dy_face[j],
                   shear_xy(i, j, k), (v(i, j, k) - v(i - 1, j, k)) * inv_dx);
  }
  [[gnu::always_inline]] Real xz(int i, int j, int k) const {
    return excess() * phi.edge_xz(i, j, k) *
           ((u(i, j, k) - u(i, j, k - 1)) * inv_dz + (w(i, j, k) - w(i - 1, j, k)) * inv_dx);
  }
  [[gnu::always_inline]] Real yz(int i, int j, int k) const {
    return lacking(phi.edge_yz(i, j, k), share.yz(i, k), (w(i, j, k) - w(i, j - 1, k)) * inv_dy_face[j],
                   shear_yz(i, j, k), (v(i, j, k) - v(i, j, k - 1)) * inv_dz);
  }
};

/// The excess stress where the solid is as viscous as the fluid.
struct ExcessStressAtInterface : ExcessStress {
  static constexpr bool kAcrossRowsOnly = true;
};

/// d/dy of a component of the velocity on its edges, of the solid: in rows first_row <= j <= end_row of this
/// rank's columns and one more on the high sides. Edges from end_row on lie in the solid. phi_at: averaged to
/// edges.
template <class FractionAt>
void find_shear(const grid::Field& component, const FractionAt& phi_at, Real solid_from, const Grid& g,
                int first_row, int end_row, grid::Field& shear) {
  const grid::Box box{0, g.nx + 1, first_row, end_row + 1, 0, g.nz + 1};
  const auto q = component.view();
  const auto out = shear.view();
  const Real* inv_dy_face = g.inv_dy_face.data();
  grid::for_each_cell(
      box, [=](int i, int j, int k) { out(i, j, k) = (q(i, j, k) - q(i, j - 1, k)) * inv_dy_face[j]; });
  extend_down(std::array{&shear}, phi_at, solid_from, end_row - 1, box);
}

void find_shear_xy(const Fraction& phi, const grid::VectorField& velocity, Real solid_from, const Grid& g,
                   int first_row, int end_row, grid::Field& shear) {
  const auto on_xy = [=](int i, int j, int k) { return phi.edge_xy(i, j, k); };
  find_shear(velocity.x, on_xy, solid_from, g, first_row, end_row, shear);
}

/// Moves what acts between rows from one force to the other.
void keep_apart(const ExcessStress& stress, int first_row, const Grid& g, grid::VectorField& force,
                grid::VectorField& across) {
  const auto move = [&](grid::Field grid::VectorField::*component, int j0, const auto& between_rows) {
    const auto all = (force.*component).view(), apart = (across.*component).view();
    grid::for_each_cell(grid::rows(g, j0, g.ny), [=](int i, int j, int k) {
      const Real part = between_rows(i, j, k);
      apart(i, j, k) = part;
      all(i, j, k) -= part;
    });
  };
  const ExcessStress s = stress;
  move(&grid::VectorField::x, first_row,
       [=](int i, int j, int k) { return (s.xy_across(i, j + 1, k) - s.xy_across(i, j, k)) * s.inv_dy[j]; });
  move(&grid::VectorField::y, std::max(first_row, 1),
       [=](int i, int j, int k) { return (s.yy(i, j, k) - s.yy(i, j - 1, k)) * s.inv_dy_face[j]; });
  move(&grid::VectorField::z, first_row,
       [=](int i, int j, int k) { return (s.yz_across(i, j + 1, k) - s.yz_across(i, j, k)) * s.inv_dy[j]; });
}

ExcessStress stress_of(const Material& m, const grid::VectorField& velocity, const grid::Field& shear_xy,
                       const grid::Field& shear_yz, Real ratio, const InterfaceShare& share, const Grid& g) {
  return {fraction_of(m, share, g),
          velocity.x.view(),
          velocity.y.view(),
          velocity.z.view(),
          shear_xy.view(),
          shear_yz.view(),
          g.inv_dy.data(),
          g.inv_dy_face.data(),
          Real(1 / g.dx),
          Real(1 / g.dz),
          ratio,
          share.view()};
}

}  // namespace

ExcessViscosity::ExcessViscosity(double ratio, Real solid_from, const InterfaceShare& share, const Grid& grid,
                                 bool split)
    : ratio_(Real(ratio)),
      solid_from_(solid_from),
      share_(share),
      grid_(grid),
      divergence_(grid),
      shear_xy_(grid, 1),
      shear_yz_(grid, 1),
      force_(grid, 0) {
  if (split) across_.emplace(grid, 0);
}

void ExcessViscosity::renew(const Material& m, const grid::VectorField& velocity, int first_row) {
  const auto& g = grid_;
  const Fraction phi = fraction_of(m, share_, g);
  const auto on_yz = [=](int i, int j, int k) { return phi.edge_yz(i, j, k); };
  // In a solid as viscous as the fluid nothing is lacking above the interface.
  end_row_ = ratio_ == 1 ? m.solid_edges_from(g.ny) : g.ny;
  find_shear_xy(phi, velocity, solid_from_, g, first_row, end_row_, shear_xy_);
  find_shear(velocity.z, on_yz, solid_from_, g, first_row, end_row_, shear_yz_);
  const ExcessStress stress = stress_of(m, velocity, shear_xy_, shear_yz_, ratio_, share_, g);
  for (int k = 0; k < g.nz; ++k) {
    if (ratio_ == 1) {
      divergence_.find(ExcessStressAtInterface{stress}, first_row, end_row_, k, force_);
    } else {
      divergence_.find(stress, first_row, end_row_, k, force_);
    }
  }
  if (across_) keep_apart(stress, first_row, g, force_, *across_);
}

void ExcessViscosity::add_work(const Material& m, const grid::VectorField& velocity, int first_row,
                               std::vector<double>& work) const {
  const ExcessStress stress = stress_of(m, velocity, shear_xy_, shear_yz_, ratio_, share_, grid_);
  if (ratio_ == 1) {
    add_stress_work(ExcessStressAtInterface{stress}, velocity, grid_, first_row, end_row_, work);
  } else {
    add_stress_work(stress, velocity, grid_, first_row, end_row_, work);
  }
}

std::vector<double> ExcessViscosity::shear_stress_sums(const Material& m, const grid::VectorField& velocity,
                                                       int first_row) const {
  const auto& g = grid_;
  grid::Field shear(g, 1);
  find_shear_xy(fraction_of(m, share_, g), velocity, solid_from_, g, first_row, g.ny, shear);
  const ExcessStress stress = stress_of(m, velocity, shear, shear, ratio_, share_, g);
  std::vector<double> sums(static_cast<std::size_t>(g.ny) + 1);
  for (int j = first_row; j <= g.ny; ++j) {
    sums[static_cast<std::size_t>(j)] =
        grid::sum_cells(grid::rows(g, j, j + 1), [=](int i, int row, int k) { return stress.xy(i, row, k); });
  }
  return sums;
}

}  // namespace softwall::solid
