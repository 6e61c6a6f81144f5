#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/grid/halo.hpp"
#include "solver/grid/solid_input.hpp"
#include "solver/grid/stage.hpp"
#include "solver/solid/advection.hpp"
#include "solver/solid/material.hpp"
#include "solver/solid/normal_extension.hpp"
#include "solver/solid/solid_edges.hpp"

/// The border between the solid and the rest of the solver: velocity and stage in, solid fraction and elastic
/// force out. Behind it stands the paper's formulation, transport of phi and B, equations (6)-(7):
///   phi^k = phi^{k-1} - dt [ beta div(u phi)^{k-1} + gamma div(u phi)^{k-2} ]
///   B^k   = B^{k-1} + dt [ beta (S - div(u B))^{k-1} + gamma (S - div(u B))^{k-2} ]
/// in the band of rows that hold solid. A second formulation needs to offer the same members.
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

  /// Advances phi and B through one substep with the velocity at its beginning (ghost cells filled).
  void transport(Material& material, const grid::VectorField& velocity, const Stage& stage, double dt);

  /// phi and the elastic force f^k + f^{k-1} for the predictor.
  [[nodiscard]] SolidInput input(const Material& material) const;

  /// Largest stable time step of elastic waves: the scheme grows visibly beyond omega dt = 0.86, with
  /// omega^2 = 4 G phi sum_ij |B_ij| / (d_i d_j) the stiffest two-cell mode of a cell.
  [[nodiscard]] double elastic_limit(const Material& material) const;

  /// Cells that the limiter has touched on this rank, summed over substeps, since the start of the program.
  [[nodiscard]] std::int64_t limited_cells() const { return limited_cells_; }
  [[nodiscard]] int first_row() const { return first_row_; }

 private:
  struct Rates {
    grid::Field phi;
    grid::TensorField B;
  };
  void find_rates(const Material& material, const grid::VectorField& velocity);
  void update(Material& material, const Stage& stage, double dt);
  void make_consistent(Material& material);
  void surround(Material& material);
  void fill_beyond_walls(Material& material) const;
  void renew_force(const Material& material);
  [[nodiscard]] int find_first_row(const Material& material) const;

  SolidSpec spec_;
  const Grid& grid_;
  const parallel::Decomposition& decomposition_;
  grid::Halo& halo_;
  Advection advection_;
  Rates now_, before_;
  SolidEdges edges_;
  std::optional<NormalExtension> normal_;  ///< present when the case asks for it
  grid::VectorField force_before_, force_sum_;
  int first_row_ = 0;
  std::int64_t limited_cells_ = 0;
};

/// A flat layer at rest: phi = 1 above the undeformed interface, B = identity.
[[nodiscard]] Material flat_layer(const Grid& grid);

}  // namespace softwall::solid
