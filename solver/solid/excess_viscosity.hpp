#pragma once

#include <vector>

#include "solver/solid/material.hpp"

/// The viscous stress of the solid beyond that of the fluid. The momentum equation counts the fluid's
/// viscosity everywhere (fluid/momentum.hpp); where the solid's differs (paper eq:stress-s), this is what is
/// missing:
///   tau_ij = mu_f 2 D_ij + phi [ G B_ij + (mu_s - mu_f) 2 D^s_ij ],
/// D^s the strain rate of the solid itself. At an edge that the interface cuts, the difference of the
/// velocity across it is that of fluid and solid together, g = (1 - phi) g_f + phi g_s, and since both feel
/// one stress,
///   mu_f g + phi [ G B + (mu_s - mu_f) g_s ] = (1 - phi) mu_f g_f + phi (mu_s g_s + G B) = tau:
/// exact, if g_s is the solid's, and wrong by the ratio of the viscosities if the mean shear g stands in for
/// it (the mean viscosity (1 - phi) mu_f + phi mu_s times g is just that).
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
  /// is not the top of its columns).
  ExcessViscosity(double ratio, Real solid_from, const Grid& grid);

  /// Finds the force, in rows from first_row on. Ghost cells of phi and of the velocity must be filled.
  void renew(const Material& material, const grid::VectorField& velocity, int first_row);
  /// d/dx_j [ phi (mu_s / mu_f - 1) 2 D^s_ij ] on the faces.
  [[nodiscard]] const grid::VectorField& force() const { return force_; }

  /// Sum over this rank's columns of the shear stress on xy edges, for each row 0 .. ny: the fluxes of which
  /// the force is the difference.
  [[nodiscard]] std::vector<double> shear_stress_sums(const Material& material,
                                                      const grid::VectorField& velocity, int first_row) const;

 private:
  Real excess_;  ///< mu_s / mu_f - 1
  Real solid_from_;
  const Grid& grid_;
  grid::Field shear_xy_, shear_yz_;  ///< du/dy and dw/dy of the solid on edges
  grid::VectorField force_;
};

}  // namespace softwall::solid
