#pragma once

#include <cstdint>
#include <memory>

#include "solver/case/case.hpp"
#include "solver/grid/halo.hpp"
#include "solver/grid/stage.hpp"
#include "solver/solid/interface_share.hpp"
#include "solver/solid/material.hpp"

/// What the two formulations of the solid have to offer to solid.hpp, the border behind which they stand:
/// each carries its own fields of the material with the flow and derives phi and B from them.
namespace softwall::solid {

/// Follows a formulation through the planes of this rank: what is to be found from phi and B while they are
/// in the cache.
class PlaneFollower {
 public:
  PlaneFollower() = default;
  PlaneFollower(const PlaneFollower&) = delete;
  PlaneFollower& operator=(const PlaneFollower&) = delete;
  virtual ~PlaneFollower() = default;

  /// Called with each plane k, in order, as soon as phi and B are as they will be wherever the elastic force
  /// in that plane reads them.
  virtual void plane_is_ready(int k) = 0;
};

class Formulation {
 public:
  Formulation() = default;
  Formulation(const Formulation&) = delete;
  Formulation& operator=(const Formulation&) = delete;
  virtual ~Formulation() = default;

  /// Lowest row that holds solid in any of this rank's columns; ny when none does. Reads the state alone: no
  /// ghost cells, nothing derived.
  [[nodiscard]] virtual int lowest_row(const Material& material) = 0;

  /// Rows worked on below that row.
  [[nodiscard]] virtual int margin() const = 0;

  /// Fills ghost cells and derives, in rows from first_row on, what is not in the state. Done again, it
  /// changes no bit: a restart does.
  virtual void make_consistent(Material& material, int first_row, PlaneFollower& follower) = 0;

  /// Advances the material through one substep with the velocity at its beginning (ghost cells filled), in
  /// rows from first_row on, and makes it consistent. Without a follower (a null pointer) nobody needs B yet:
  /// a formulation that derives it may leave it as it was.
  virtual void transport(Material& material, const grid::VectorField& velocity, const Stage& stage, double dt,
                         int first_row, PlaneFollower* follower) = 0;

  /// An edge where phi is at least this lies in the solid: its own shear is the solid's
  /// (excess_viscosity.hpp).
  [[nodiscard]] virtual Real solid_from() const = 0;
  /// Whose stress an edge on the interface bears.
  [[nodiscard]] virtual const InterfaceShare& interface_share() const = 0;

  /// Cells in which B had to be changed, or is not to be trusted, on this rank, summed over substeps.
  [[nodiscard]] virtual std::int64_t limited_cells() const = 0;
};

/// The formulation that the case asks for. Everything it is given must outlive it.
[[nodiscard]] std::unique_ptr<Formulation> make_formulation(const SolidSpec& spec, const Grid& grid,
                                                            const parallel::Decomposition& decomposition,
                                                            grid::Halo& halo);

}  // namespace softwall::solid
