#pragma once

#include <cstdint>
#include <functional>

#include "solver/grid/field.hpp"
#include "solver/grid/stage.hpp"
#include "solver/solid/interface_share.hpp"
#include "solver/solid/material.hpp"

/// What the two formulations of the solid have to offer to solid.hpp, the border behind which they stand:
/// each carries its own fields of the material with the flow and derives phi and B from them.
namespace softwall::solid {

/// Called with each plane k of this rank, in order, as soon as phi and B are as they will be wherever the
/// force in that plane reads them: while they are in the cache.
using PlaneReady = std::function<void(int k)>;

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
  virtual void make_consistent(Material& material, int first_row, const PlaneReady& ready) = 0;

  /// Advances the material through one substep with the velocity at its beginning (ghost cells filled), in
  /// rows from first_row on, and makes it consistent; without `ready` perhaps not B, which a formulation that
  /// derives it leaves as it was.
  virtual void transport(Material& material, const grid::VectorField& velocity, const Stage& stage, double dt,
                         int first_row, const PlaneReady& ready) = 0;

  /// An edge where phi is at least this lies in the solid: its own shear is the solid's
  /// (excess_viscosity.hpp).
  [[nodiscard]] virtual Real solid_from() const = 0;
  /// Whose stress an edge on the interface bears.
  [[nodiscard]] virtual const InterfaceShare& interface_share() const = 0;

  /// Cells in which B had to be changed, or is not to be trusted, on this rank, summed over substeps.
  [[nodiscard]] virtual std::int64_t limited_cells() const = 0;
};

}  // namespace softwall::solid
