#include "solver/solid/excess_viscosity.hpp"

#include <algorithm>
#include <array>

#include "solver/grid/cell_loop.hpp"
#include "solver/solid/column_extension.hpp"
#include "solver/solid/fraction.hpp"
#include "solver/solid/stress_work.hpp"

namespace softwall::solid {

/// What the fluid's viscous stress lacks, where its components live.
struct ExcessViscosity::Stress {
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
struct ExcessViscosity::StressAtInterface : Stress {
  static constexpr bool kAcrossRowsOnly = true;
};

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

/// d/dy of a component of the velocity on its edges, of the solid: in rows first_row <= j <= end_row of this
/// rank's columns and one more on the high sides. Edges from end_row on lie in the solid. phi_at: averaged to
/// edges.
template <class FractionAt>
void ExcessViscosity::find_shear(const grid::Field& component, const FractionAt& phi_at, int first_row,
                                 int end_row, grid::Field& shear) const {
  const grid::Box box{0, grid_.nx + 1, first_row, end_row + 1, 0, grid_.nz + 1};
  const auto q = component.view();
  const auto out = shear.view();
  const Real* inv_dy_face = grid_.inv_dy_face.data();
  grid::for_each_cell(
      box, [=](int i, int j, int k) { out(i, j, k) = (q(i, j, k) - q(i, j - 1, k)) * inv_dy_face[j]; });
  extend_down(std::array{&shear}, phi_at, solid_from_, end_row - 1, box);
}

void ExcessViscosity::find_shear_xy(const Material& m, const grid::VectorField& velocity, int first_row,
                                    int end_row, grid::Field& shear) const {
  const Fraction phi = fraction_of(m, share_, grid_);
  const auto on_xy = [=](int i, int j, int k) { return phi.edge_xy(i, j, k); };
  find_shear(velocity.x, on_xy, first_row, end_row, shear);
}

/// Moves what acts between rows from one force to the other.
void ExcessViscosity::keep_across_apart(const Stress& stress, int first_row) {
  const auto move = [&](grid::Field grid::VectorField::*component, int j0, const auto& between_rows) {
    const auto all = (force_.*component).view(), apart = (across_.value().*component).view();
    grid::for_each_cell(grid::rows(grid_, j0, grid_.ny), [=](int i, int j, int k) {
      const Real part = between_rows(i, j, k);
      apart(i, j, k) = part;
      all(i, j, k) -= part;
    });
  };
  const Stress s = stress;
  move(&grid::VectorField::x, first_row,
       [=](int i, int j, int k) { return (s.xy_across(i, j + 1, k) - s.xy_across(i, j, k)) * s.inv_dy[j]; });
  move(&grid::VectorField::y, std::max(first_row, 1),
       [=](int i, int j, int k) { return (s.yy(i, j, k) - s.yy(i, j - 1, k)) * s.inv_dy_face[j]; });
  move(&grid::VectorField::z, first_row,
       [=](int i, int j, int k) { return (s.yz_across(i, j + 1, k) - s.yz_across(i, j, k)) * s.inv_dy[j]; });
}

ExcessViscosity::Stress ExcessViscosity::stress_of(const Material& m, const grid::VectorField& velocity,
                                                   const grid::Field& shear_xy,
                                                   const grid::Field& shear_yz) const {
  return {.phi = fraction_of(m, share_, grid_),
          .u = velocity.x.view(),
          .v = velocity.y.view(),
          .w = velocity.z.view(),
          .shear_xy = shear_xy.view(),
          .shear_yz = shear_yz.view(),
          .inv_dy = grid_.inv_dy.data(),
          .inv_dy_face = grid_.inv_dy_face.data(),
          .inv_dx = Real(1 / grid_.dx),
          .inv_dz = Real(1 / grid_.dz),
          .ratio = ratio_,
          .share = share_.view()};
}

void ExcessViscosity::renew(const Material& m, const grid::VectorField& velocity, int first_row) {
  const auto& g = grid_;
  const Fraction phi = fraction_of(m, share_, g);
  const auto on_yz = [=](int i, int j, int k) { return phi.edge_yz(i, j, k); };
  // In a solid as viscous as the fluid nothing is lacking above the interface.
  end_row_ = ratio_ == 1 ? m.solid_edges_from(g.ny) : g.ny;
  find_shear_xy(m, velocity, first_row, end_row_, shear_xy_);
  find_shear(velocity.z, on_yz, first_row, end_row_, shear_yz_);
  const Stress stress = stress_of(m, velocity, shear_xy_, shear_yz_);
  for (int k = 0; k < g.nz; ++k) {
    if (ratio_ == 1) {
      divergence_.find(StressAtInterface{stress}, first_row, end_row_, k, force_);
    } else {
      divergence_.find(stress, first_row, end_row_, k, force_);
    }
  }
  if (across_) keep_across_apart(stress, first_row);
}

void ExcessViscosity::add_work(const Material& m, const grid::VectorField& velocity, int first_row,
                               std::vector<double>& work) const {
  const Stress stress = stress_of(m, velocity, shear_xy_, shear_yz_);
  if (ratio_ == 1) {
    add_stress_work(StressAtInterface{stress}, velocity, grid_, first_row, end_row_, work);
  } else {
    add_stress_work(stress, velocity, grid_, first_row, end_row_, work);
  }
}

std::vector<double> ExcessViscosity::shear_stress_sums(const Material& m, const grid::VectorField& velocity,
                                                       int first_row) const {
  const auto& g = grid_;
  grid::Field shear(g, 1);
  find_shear_xy(m, velocity, first_row, g.ny, shear);
  const Stress stress = stress_of(m, velocity, shear, shear);
  std::vector<double> sums(static_cast<std::size_t>(g.ny) + 1);
  for (int j = first_row; j <= g.ny; ++j) {
    sums[static_cast<std::size_t>(j)] =
        grid::sum_cells(grid::rows(g, j, j + 1), [=](int i, int row, int k) { return stress.xy(i, row, k); });
  }
  return sums;
}

}  // namespace softwall::solid
