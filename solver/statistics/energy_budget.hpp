#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "solver/fluid/momentum_sweep.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::statistics {

/// Where the kinetic energy comes from and goes to, row by row, from the very forces of the scheme, so that
/// the terms add up to its rate of change (but for what the time scheme does in a step, and what happens
/// between two samples). A force f does
///   power = <u f_x> + <w f_z> + [dy_face[j] <v f_y>[j] + dy_face[j+1] <v f_y>[j+1]] / (2 dy[j])
/// in row j, and sum of power times dy is its power over the plane. That of convection and of the pressure
/// gradient add up to zero; that of a stress adds up to minus its work s_ij du_i/dx_j
/// (solid/stress_work.hpp). What <u> <f_x> takes of it is the mean flow's part, the rest that of the
/// fluctuations.
struct BudgetKind {
  std::string_view name, unit, description;
};
inline constexpr std::array<BudgetKind, 20> kBudgetKinds{{
    {"u", "U_b", "mean streamwise velocity"},
    {"uv", "U_b^2", "momentum flux <u v> on the lower faces of the rows, as the scheme transports it"},
    {"kinetic", "rho U_b^2", "kinetic energy"},
    {"elastic", "rho U_b^2", "elastic energy of the solid"},
    {"force_convection", "rho U_b^2/h", "mean along x of -d(u_i u_j)/dx_j"},
    {"force_viscous", "rho U_b^2/h",
     "mean along x of the viscous force that the fluid's viscosity has everywhere"},
    {"force_excess", "rho U_b^2/h", "mean along x of the viscous force beyond it, of the solid"},
    {"force_elastic", "rho U_b^2/h", "mean along x of the elastic force"},
    {"force_driving", "rho U_b^2/h", "driving gradient"},
    {"power_convection", "rho U_b^3/h", "power of -d(u_i u_j)/dx_j"},
    {"power_viscous", "rho U_b^3/h", "power of the viscous force that the fluid's viscosity has everywhere"},
    {"power_excess", "rho U_b^3/h", "power of the viscous force beyond it"},
    {"power_elastic", "rho U_b^3/h", "power of the elastic force"},
    {"power_driving", "rho U_b^3/h", "power of the driving gradient"},
    {"power_pressure", "rho U_b^3/h",
     "power of the gradient of the pressure that keeps the flow without divergence at the moment"},
    {"work_viscous", "rho U_b^3/h", "dissipation by the viscosity of the fluid"},
    {"work_excess", "rho U_b^3/h", "dissipation by what the solid has beyond it"},
    {"work_elastic", "rho U_b^3/h", "work of the flow on the elastic solid"},
    {"rate_u", "U_b^2/h", "change of u since the sample before, over the time since then"},
    {"rate_kinetic", "rho U_b^3/h", "change of kinetic since the sample before, over the time since then"},
}};

class EnergyBudget {
 public:
  explicit EnergyBudget(const grid::Grid& grid) : rows_(static_cast<std::size_t>(grid.ny)), sweep_(grid) {}

  /// Plane means at this moment, [kind][row], the same on all ranks; `elapsed`: time since the sample before,
  /// h / U_b. Nothing the first time, which only says what later changes are changes of. Collective; between
  /// two steps, ghost cells filled as advance() leaves them.
  [[nodiscard]] std::optional<std::vector<double>> sample(const time::State& state, time::Setup& setup,
                                                          double elapsed);

  /// What the next sample is compared with: u and kinetic by row, nothing before the first.
  [[nodiscard]] const std::vector<double>& before() const { return before_; }
  /// Continues from what before() returned after a sample. Throws std::runtime_error when it belongs to
  /// another grid.
  void continue_from(std::span<const double> before);

 private:
  std::size_t rows_;
  fluid::MomentumSweep sweep_;
  std::vector<double> before_;
};

}  // namespace softwall::statistics
