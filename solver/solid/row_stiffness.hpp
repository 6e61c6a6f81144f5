#pragma once

#include "solver/parallel/line_memory.hpp"
#include "solver/solid/interface_share.hpp"
#include "solver/solid/material.hpp"

/// What a change of velocity within a substep adds to the stress between rows of cells, taken implicitly. A
/// change q that builds up evenly over a step of length dt moves the material by (dt / 4) q more in the mean,
/// and to first order this changes the elastic force in y by
///   (dt / 4) d/dy [ phi G B_yy dq/dy ],
/// each component of q by itself. So what an explicit substep changed, u* - u^{k-1}, becomes q:
///   q - (dt^2 / 4) d/dy [ c dq/dy ] = u* - u^{k-1},   u* = u^{k-1} + q,
/// a tridiagonal system for each column and component. Where the solid does not reach, c = 0 and nothing
/// changes; where it rests, q = 0, so that what is at equilibrium is as without. The coefficient is not phi G
/// B_yy but (1 + kSpare) times that: it must outweigh what is left explicit of waves that run obliquely
/// through sheared material (Solid::elastic_limit), and more of it than is exact makes no wave grow, as long
/// as it is the same in all substeps.
namespace softwall::solid {

/// Of a step, h / U_b, and alpha dt of a substep times the viscosity of the fluid.
struct ImplicitWeights {
  double dt, viscous;
};

class RowStiffness {
 public:
  static constexpr double kSpare = 0.25;

  /// `share`: of the shear stress of an edge on the interface; must outlive it.
  RowStiffness(const SolidSpec& spec, const InterfaceShare& share, const Grid& grid);

  /// Replaces u* by u^{k-1} + q in rows from first_row on. Reads phi and B of columns and planes -1, too;
  /// ghost cells of the velocities are neither read nor written.
  void apply(const Material& material, const grid::VectorField& before, const ImplicitWeights& weights,
             int first_row, grid::VectorField& velocity);

 private:
  using Row = parallel::LineVector<Real>;
  struct Edges;
  template <bool kViscous>
  void apply(const Edges& edges, const grid::VectorField& before, int first_row, grid::VectorField& velocity);
  template <class Coefficient>
  void solve(int row0, const Real* inverse_height, const Coefficient& c, View<const Real> before,
             View<Real> velocity, int k);
  [[nodiscard]] Real* row(Row& rows, int j) const { return rows.data() + std::ptrdiff_t(j) * stride_; }

  double G_, viscosity_ratio_;
  const InterfaceShare& share_;
  const Grid& grid_;
  std::ptrdiff_t stride_;
  Row low_, high_;  ///< coefficients at the sides of a row of unknowns
  Row rest_;        ///< 1 - ratio of the row below
  Row change_;      ///< q of a plane
  Row ratio_;       ///< upper off-diagonal over pivot of a plane
};

}  // namespace softwall::solid
