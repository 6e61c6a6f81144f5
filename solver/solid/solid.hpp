#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "solver/case/case.hpp"
#include "solver/grid/halo.hpp"
#include "solver/grid/solid_input.hpp"
#include "solver/grid/stage.hpp"
#include "solver/solid/elastic_force.hpp"
#include "solver/solid/excess_viscosity.hpp"
#include "solver/solid/formulation.hpp"
#include "solver/solid/material.hpp"
#include "solver/solid/row_stiffness.hpp"

/// The border between the solid and the rest of the solver: velocity and stage in, solid fraction, elastic
/// and excess viscous force out. Behind it stands a formulation (formulation.hpp), which moves the material;
/// what phi and B then do to the flow is the same for all, in the band of rows that hold solid.
namespace softwall::solid {

class Solid {
 public:
  Solid(const SolidSpec& spec, const Grid& grid, const parallel::Decomposition& decomposition,
        grid::Halo& halo);

  /// To be called before the first step on a material: fills its ghost cells and derives what is not in the
  /// state.
  void start(Material& material);

  /// Lets the band of rows follow the solid; to be called once at the end of a step.
  void renew_band(Material& material);

  /// Advances the material through one substep with the velocity at its beginning (ghost cells filled), after
  /// finding the excess viscous force of that moment.
  void transport(Material& material, const grid::VectorField& velocity, const Stage& stage, double dt);

  /// Where the stress between rows is implicit: lets it resist what a substep has changed of the velocity
  /// since `before` (row_stiffness.hpp). Elsewhere does nothing.
  void apply_implicit_stress(const Material& material, const grid::VectorField& before,
                             const ImplicitWeights& weights, grid::VectorField& velocity);

  /// phi, the two elastic forces of a substep (grid/solid_input.hpp) and the excess viscous force of moment
  /// k-1 for the predictor.
  [[nodiscard]] SolidInput input(const Material& material) const;

  /// What the stresses of the solid do to the flow at this moment, for statistics: forces on the faces, in
  /// rows first_row() <= j < end_row, and their work, sums over this rank's columns by row (stress_work.hpp).
  /// Those of the excess viscous stress are over mu_f; `excess` and `across`, its part between rows where
  /// that is kept apart, are null where there is none.
  struct Action {
    const grid::VectorField *elastic = nullptr, *excess = nullptr, *across = nullptr;
    int excess_end_row = 0;
    std::vector<double> elastic_work, excess_work;
  };
  /// Between two steps; ghost cells filled. Changes no result of the next one, which finds the excess viscous
  /// force anew.
  [[nodiscard]] Action action(const Material& material, const grid::VectorField& velocity);

  /// Sum over this rank's columns of the excess viscous shear stress over mu_f on xy edges, for each row 0 ..
  /// ny; empty when the viscosities are equal. Ghost cells filled.
  [[nodiscard]] std::vector<double> excess_shear_sums(const Material& material,
                                                      const grid::VectorField& velocity) const;

  /// Largest stable time step of the elastic waves that are explicit (case/step_limits.hpp).
  [[nodiscard]] double elastic_limit(const Material& material) const;

  /// Cells that the limiter of B touched, or torn cells of a map, on this rank, in the last substep of each
  /// step, summed over steps since the start of the program.
  [[nodiscard]] std::int64_t limited_cells() const { return limited_cells_; }
  [[nodiscard]] int first_row() const { return first_row_; }
  [[nodiscard]] const InterfaceShare& interface_share() const { return formulation_->interface_share(); }

 private:
  [[nodiscard]] int find_first_row(const Material& material) const;

  SolidSpec spec_;
  const Grid& grid_;
  const parallel::Decomposition& decomposition_;
  std::unique_ptr<Formulation> formulation_;
  std::optional<ExcessViscosity> excess_viscosity_;  ///< where the fluid's stress alone is not the whole
  ElasticForce force_;
  std::optional<RowStiffness> row_stiffness_;  ///< where it is implicit
  bool splits_viscosity_ = false;              ///< its part between rows is implicit
  int first_row_ = 0;
  std::int64_t limited_cells_ = 0;
};

/// A flat layer at rest: phi = 1 above the undeformed interface, B = identity; with a reference map d = 0,
/// and phi and B wait for start().
[[nodiscard]] Material flat_layer(const Grid& grid, SolidFormulation formulation);

}  // namespace softwall::solid
