#pragma once

#include <vector>

#include "solver/case/elastic_law.hpp"
#include "solver/solid/interface_share.hpp"
#include "solver/solid/material.hpp"
#include "solver/solid/stress_divergence.hpp"

/// Force of the elastic stress s (case/elastic_law.hpp) on the faces, f_i = d/dx_j [ phi s_ij ], which is
/// d/dx_j [ phi G (B_ij - delta_ij) ] of a neo-Hookean solid. phi G delta_ij is the gradient of a center
/// field, which the pressure absorbs exactly on this grid: it is left out, so that a wall at rest feels no
/// force at all. For the same reason a multiple of the identity added to B (as the limiter does) moves
/// nothing.
namespace softwall::solid {

class ElasticForce {
 public:
  /// `share` must outlive it.
  ElasticForce(ElasticLaw<Real> law, const InterfaceShare& share, const Grid& grid);

  /// The present force becomes that of the moment before. To be called before the material moves on.
  void keep();

  /// Finds the present force in plane k, rows from first_row on; elsewhere it stays as it is. Reads the ghost
  /// cells of `material` and its planes k - 1 and k + 1.
  void find(const Material& material, int first_row, int k);

  /// To be called at the end of a step's first substep, at t + 8/15 dt. Finds the present force; and the
  /// force kept, that of the beginning of the step, becomes that of its middle, which lies between the two in
  /// time.
  void find_middle(const Material& material, int first_row, int k);

  /// Adds the work of the stress at this moment (stress_work.hpp), in rows from first_row on.
  void add_work(const Material& material, const grid::VectorField& velocity, int first_row,
                std::vector<double>& work) const;

  [[nodiscard]] const grid::VectorField& now() const { return now_; }
  [[nodiscard]] const grid::VectorField& before() const { return before_; }

 private:
  template <class Visit>
  void with_stress(const Material& material, int first_row, const Visit& visit) const;

  ElasticLaw<Real> law_;
  const InterfaceShare& share_;
  const Grid& grid_;
  StressDivergence divergence_;
  grid::VectorField now_, before_;
};

}  // namespace softwall::solid
