#pragma once

#include "solver/case/case.hpp"
#include "solver/grid/halo.hpp"
#include "solver/solid/formulation.hpp"
#include "solver/solid/reference_map/extrapolation.hpp"
#include "solver/solid/reference_map/isochoric_extension.hpp"
#include "solver/solid/reference_map/mending.hpp"
#include "solver/solid/reference_map/strain_sweep.hpp"
#include "solver/solid/reference_map/surface.hpp"
#include "solver/solid/reference_map/transport.hpp"

/// The reference map (Kamrin, Rycroft & Nave, J. Mech. Phys. Solids 60, 2012; Rycroft, Wu, Yu & Kamrin, J.
/// Fluid Mech. 898, 2020): instead of phi and B the solid carries where its material came from, x - d,
///   d^k = d^{k-1} + dt [ beta r^{k-1} + gamma r^{k-2} ],   r = u - u.grad d - what relaxes volume
///   (volume.hpp)
/// and both follow from d: B from its gradient (strain.hpp), phi from the material surface y - d_y = its
/// height at rest (surface.hpp). Nothing is stretched by the fluid, nothing smears. Below the surface d is
/// extrapolated after every substep (extrapolation.hpp, isochoric_extension.hpp). Where the grid tears it, it
/// is mended (mending.hpp). On the upper wall it is bonded: d = 0.
namespace softwall::solid::reference_map {

class ReferenceMap : public Formulation {
 public:
  ReferenceMap(const SolidSpec& spec, const Grid& grid, const parallel::Decomposition& decomposition,
               grid::Halo& halo);

  [[nodiscard]] int lowest_row(const Material& material) override;
  /// The surface sinks by less than a row before the last substep of a step (2/3 dt, at a safety of 0.86 or
  /// less and without a fixed dt), and a steep one bears stress on the edge below. Further down d is
  /// extrapolated.
  [[nodiscard]] int margin() const override { return 2; }
  void make_consistent(Material& material, int first_row, PlaneFollower& follower) override;
  void transport(Material& material, const grid::VectorField& velocity, const Stage& stage, double dt,
                 int first_row, PlaneFollower* follower) override;
  /// Under a flat surface: both rows whose difference it takes have their centers in the solid.
  [[nodiscard]] Real solid_from() const override { return Real(0.75); }
  [[nodiscard]] const InterfaceShare& interface_share() const override { return share_; }
  /// Torn cells (mending.hpp).
  [[nodiscard]] std::int64_t limited_cells() const override { return limited_cells_; }

 private:
  void advance(Material& material, const grid::VectorField& velocity, const Stage& stage, double dt,
               int first_row);
  [[nodiscard]] PlaneOfRates recent_rates(int k);
  void update(grid::VectorField& displacement, const Stage& stage, double dt, const RowsOfAPlane& rows);
  void extend_below_surface(Material& material, int first_row);
  void fill_ghosts(grid::VectorField& displacement, int first_row);
  [[nodiscard]] grid::RowSpan rows_with_ghosts(int first_row) const;
  [[nodiscard]] double row_height_at(double y) const;
  void fill_beyond_walls(grid::VectorField& displacement, int first_row) const;
  void derive(Material& material, int first_row);
  std::int64_t find_strain(Material& material, int first_row, PlaneFollower& follower);
  void continue_fraction(Material& material, int first_row) const;

  const Grid& grid_;
  WenoWeights weights_;
  const parallel::Decomposition& decomposition_;
  grid::Halo& halo_;
  RelaxationSpeeds speeds_;
  grid::VectorField recent_;  ///< r^{k-1} in the last planes where it was found
  grid::VectorField before_;  ///< r^{k-2}; where d is up to date, r^{k-1}
  grid::Field volume_error_;  ///< at centers
  bool is_neo_hookean_;
  Damage damage_;
  Mending mending_;
  StrainSweep strain_;
  Heights own_heights_, wide_heights_;
  double mean_height_ = 0;  ///< of the surface, h
  Extrapolation extrapolation_;
  IsochoricExtension isochoric_extension_;
  CellFractions fractions_;
  InterfaceShare share_;
  std::int64_t limited_cells_ = 0;
};

}  // namespace softwall::solid::reference_map
