#pragma once

#include "solver/case/elastic_law.hpp"
#include "solver/parallel/line_memory.hpp"
#include "solver/solid/formulation.hpp"
#include "solver/solid/material.hpp"

/// What a change of velocity within a substep adds to the stress between rows of cells, taken implicitly. A
/// change q that builds up evenly over a step of length dt moves the material by (dt / 4) q more in the mean,
/// and to first order this changes the elastic force in y by
///   (dt / 4) d/dy [ phi G B_yy dq/dy ],
/// each component of q by itself. So what an explicit substep changed, u^ - u^{k-1}, becomes q, equation (18)
/// of solver/solid/README.md:
///   q - d/dy [ c dq/dy ] = u^ - u^{k-1},   u* = u^{k-1} + q,   c = (1 + s) (dt^2 / 4) phi G B_yy,
/// a tridiagonal system for each column and component. Where the solid does not reach, c = 0 and nothing
/// changes; where it rests, q = 0, so that what is at equilibrium is as without. The factor 1 + s (s:
/// step_limits::kSpareStiffness) is there since c must outweigh what is left explicit of waves that run
/// obliquely through sheared material; more of it than is exact makes no wave grow, as long as it is the same
/// in all substeps. Of a Mooney-Rivlin solid c holds c1 B_yy in place of G B_yy and, for the component of q
/// along t, c2 times what case/cofactor_stiffness.hpp takes for C_tt. Of one more viscous than the fluid c
/// also holds what is implicit of its viscosity, alpha dt of the substep times the viscosity that the fluid's
/// lacks.
namespace softwall::solid {

struct RowCoefficients;

struct ImplicitWeights {
  double dt;       ///< of the whole step
  double viscous;  ///< alpha dt of the substep times the viscosity of the fluid
  double driving;  ///< 2 alpha dt times the driving gradient expected
};

class RowStiffness {
 public:
  /// `formulation` must outlive it.
  RowStiffness(const SolidSpec& spec, const Formulation& formulation, const Grid& grid);

  /// Replaces u^ by u^{k-1} + q in rows from first_row on. Reads phi and B of columns and planes -1, too;
  /// ghost cells of the velocities are neither read nor written.
  void apply(const Material& material, const grid::VectorField& before, const ImplicitWeights& weights,
             int first_row, grid::VectorField& velocity);

 private:
  using Row = parallel::LineVector<Real>;
  /// Coefficients on the edges of a row: of the difference across the edge itself, and across the one above.
  struct Side {
    Row own, above;
  };
  /// The systems of a plane: 1 over the height around an unknown, the lowest row of unknowns, what is added
  /// to every right-hand side and taken from the result.
  struct Systems {
    const Real* inverse_height;
    int row0, k;
    Real constant;
  };
  template <bool kViscous>
  void apply(const RowCoefficients& edges, const grid::VectorField& before, Real driving, int first_row,
             grid::VectorField& velocity);
  template <bool kViscous, bool kNeoHookean>
  void apply_law(const RowCoefficients& edges, const grid::VectorField& before, Real driving, int first_row,
                 grid::VectorField& velocity);
  template <bool kViscous, class FractionAt, class ShareAt, class StretchAt>
  void fill_edges(const RowCoefficients& edges, int j, const FractionAt& fraction, const ShareAt& a,
                  const StretchAt& stretch, Side& side) const;
  template <bool kAbove, class Coefficients>
  void solve(const Systems& systems, const Coefficients& c, View<const Real> before, View<Real> velocity);
  template <bool kAbove, class Coefficients>
  void eliminate(const Systems& systems, const Coefficients& c, View<const Real> before,
                 View<Real> predicted);
  template <bool kAbove>
  void eliminate_row(const Systems& systems, int j, const Real* old, const Real* predicted);
  template <bool kAbove>
  void substitute_back(const Systems& systems, View<const Real> before, View<Real> velocity);
  /// Row j of a plane; there is one for -1.
  [[nodiscard]] Real* row(Row& rows, int j) const { return rows.data() + std::ptrdiff_t(j + 1) * stride_; }

  ElasticLaw<double> law_;
  double viscosity_ratio_;
  const Formulation& formulation_;
  const Grid& grid_;
  std::ptrdiff_t stride_;
  Side low_, high_;  ///< of a row of unknowns
  Row rest_;         ///< 1 - ratio of the row below
  Row change_;       ///< q of a plane
  Row ratio_, second_ratio_;
};

}  // namespace softwall::solid
