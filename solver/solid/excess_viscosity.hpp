#pragma once

#include <optional>
#include <vector>

#include "solver/solid/interface_share.hpp"
#include "solver/solid/material.hpp"
#include "solver/solid/stress_divergence.hpp"

/// The viscous stress beyond that of the fluid. The momentum equation counts mu_f times the difference g of
/// the velocity everywhere (fluid/momentum.hpp). In the solid (paper eq:stress-s) this lacks
///   phi (mu_s - mu_f) 2 D^s_ij,
/// D^s the strain rate of the solid itself. At an edge that the interface cuts, g is that of fluid and solid
/// together, g = (1 - phi) g_f + phi g_s, and the stress there, shared as interface_share.hpp says, lacks
///   (1 - s) mu_f g_f + s mu_s g_s - mu_f g,   g_f = (g - phi g_s) / (1 - phi)
/// (with s = phi: phi (mu_s - mu_f) g_s). The mean viscosity times g would be wrong by the ratio of the
/// viscosities.
///
/// Across an interface that is nearly flat only du/dy and dw/dy jump: the velocity is continuous, hence all
/// its derivatives along the interface, and, without divergence, dv/dy. So g_s is du/dy (dw/dy) of the edge
/// itself where the edge lies in the solid, and that of the row above where it does not, as for B (skin.hpp):
/// first order where it stands, and second in the flow, since that is one row. All else is local. A line
/// through the two rows above would be of higher order there, but amplifies noise.
///
/// Everything here is over mu_f: a stress is a rate of strain, 1 / time.
namespace softwall::solid {

class ExcessViscosity {
 public:
  /// `ratio`: mu_s / mu_f. `solid_from`: an edge lies in the solid where phi, averaged to it, is at least
  /// this, and so it is all the way up the column; 0: every edge, so that its own shear counts (a body that
  /// is not the top of its columns). `share`: of the shear stress of an edge on the interface; must outlive
  /// it.
  /// `split`: keep what acts between rows apart.
  ExcessViscosity(double ratio, Real solid_from, const InterfaceShare& share, const Grid& grid,
                  bool split = false);

  /// Finds the force, in rows from first_row on. Ghost cells of phi and of the velocity must be filled.
  void renew(const Material& material, const grid::VectorField& velocity, int first_row);
  /// Force of what the fluid's stress lacks, on the faces, in rows first_row <= j < end_row(): elsewhere
  /// nothing is lacking, whatever the field holds there.
  [[nodiscard]] const grid::VectorField& force() const { return force_; }
  [[nodiscard]] int end_row() const { return end_row_; }
  /// The part of the force that each component owes to its own differences between rows: d/dy of tau_xy
  /// without dv/dx, of tau_yy, and of tau_yz without dv/dz. Where it is kept apart, force() does not hold it;
  /// a null pointer where it is not.
  [[nodiscard]] const grid::VectorField* across() const { return across_ ? &*across_ : nullptr; }

  /// Adds the work of this stress (stress_work.hpp) at the moment of the last renew().
  void add_work(const Material& material, const grid::VectorField& velocity, int first_row,
                std::vector<double>& work) const;

  /// Sum over this rank's columns of the shear stress on xy edges, for each row 0 .. ny: the fluxes of which
  /// the force is the difference.
  [[nodiscard]] std::vector<double> shear_stress_sums(const Material& material,
                                                      const grid::VectorField& velocity, int first_row) const;

 private:
  struct Stress;
  struct StressAtInterface;
  template <class FractionAt>
  void find_shear(const grid::Field& component, const FractionAt& phi_at, int first_row, int end_row,
                  grid::Field& shear) const;
  void find_shear_xy(const Material& material, const grid::VectorField& velocity, int first_row, int end_row,
                     grid::Field& shear) const;
  [[nodiscard]] Stress stress_of(const Material& material, const grid::VectorField& velocity,
                                 const grid::Field& shear_xy, const grid::Field& shear_yz) const;
  void keep_across_apart(const Stress& stress, int first_row);

  Real ratio_;  ///< mu_s / mu_f
  Real solid_from_;
  const InterfaceShare& share_;
  const Grid& grid_;
  StressDivergence divergence_;
  grid::Field shear_xy_, shear_yz_;  ///< du/dy and dw/dy of the solid on edges
  grid::VectorField force_;
  std::optional<grid::VectorField> across_;
  int end_row_ = 0;
};

}  // namespace softwall::solid
