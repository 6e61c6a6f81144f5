#pragma once

#include <array>
#include <initializer_list>
#include <vector>

#include "solver/grid/halo.hpp"
#include "solver/solid/material.hpp"

/// B around a solid of any shape. Where phi (averaged to the place of each component) is below a threshold, B
/// is continued from the solid along the normal of the interface, grad phi . grad B = 0: layer by layer, each
/// place takes the mean of those neighbours that have a value, weighted with how much more solid they are,
///   B_i = sum_n w_n B_n / sum_n w_n,     w_n = max(phi_n - phi_i, 0) / h_n^2  (and a little for equal ones),
/// the first-order upwind form. What lies farther than kLayers from the solid is given B = identity.
/// (skin.hpp does the same for a layer on the upper wall, where the solid is always above.)
///
/// Depends on phi and on B in the solid only, so that doing it again changes no bit.
namespace softwall::solid {

class NormalExtension {
 public:
  /// Layers of cells that are filled: more than the half width of a smeared interface and the reach of WENO.
  static constexpr int kLayers = 8;

  NormalExtension(const Grid& grid, const parallel::Decomposition& decomposition, grid::Halo& halo);

  /// Replaces the shear components. Ghost cells of phi and of these must be filled, and are afterwards.
  void extend_shear(Material& material, double threshold);
  /// Extends the normal components in the same way.
  void extend_normal(Material& material, double threshold);

 private:
  /// Values for all components of one place, to be written once a layer is complete.
  struct Update {
    int i, j, k;
    std::array<Real, 3> value;
  };
  /// Smallest box of cells that holds all solid, in global indices, the same on all ranks.
  [[nodiscard]] grid::Box solid_box(const grid::Field& phi, double threshold) const;
  /// The part of it, grown by `cells`, in which this rank knows the neighbours of every place.
  [[nodiscard]] grid::Box near_solid(const grid::Box& solid, int cells, int rows) const;
  template <class FractionAt>
  void mark(const FractionAt& fraction, double threshold, int rows, grid::Field& known) const;
  template <class FractionAt, std::size_t kCount>
  void grow(const FractionAt& fraction, const std::array<grid::Field*, kCount>& components,
            const grid::Box& box, int rows, grid::Field& known);
  void exchange(std::initializer_list<grid::Field*> fields, const grid::Box& solid, int cells);
  template <std::size_t kCount>
  void clear(const std::array<grid::Field*, kCount>& components, const grid::Field& known, int rows,
             Real value) const;

  const Grid& grid_;
  const parallel::Decomposition& decomposition_;
  grid::Halo& halo_;
  grid::Field at_center_, at_xy_, at_xz_, at_yz_;  ///< 1 where B is the solid's or continued from it, else 0
  std::vector<Update> updates_;                    ///< work
};

}  // namespace softwall::solid
