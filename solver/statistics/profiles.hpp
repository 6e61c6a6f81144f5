#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "solver/run_directory/block_statistics.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

/// Plane means (over x and z) of one moment, row by row.
///
/// Squares are taken of the staggered values where they live and then averaged, so that
/// (uu + vv + ww) / 2 is the kinetic energy the scheme conserves:
///   uu[j] = <u u> on x faces, ww[j] = <w w> on z faces, vv[j] = (<v v> on face j + <v v> on face j+1) / 2.
/// The stresses on y faces are the means of exactly the fluxes that the momentum equation differences:
///   viscous_stress - uv = <flux_xy> and the solid's excess viscous stress,
///   elastic_stress = <s s_xy>, s the share of the solid (solid/interface_share.hpp) and s_xy = G B_xy of a
///   neo-Hookean solid (case/elastic_law.hpp),
/// so their sum obeys the discrete balance d/dt <u> = P + d/dy (viscous_stress - uv + elastic_stress).
namespace softwall::statistics {

/// Where each profile stands in PlaneMeans; those from kPhi on exist with an elastic wall only.
enum ProfileIndex : std::size_t {
  kU,
  kV,
  kW,
  kUu,
  kVv,
  kWw,
  kP,
  kPp,
  kUv,
  kViscousStress,
  kVFace,
  kVvFace,
  kPhi,
  kFluidU,
  kElasticStress,
  kElasticXx,
  kElasticYy,
  kElasticZz,
  kProfileCount
};

struct ProfileKind {
  std::string_view name;
  analysis::Location location;
  /// Empty where solver/run_directory/quantities.hpp knows the name.
  std::string_view unit, description;
};

/// The profiles of a flow, in the order of ProfileIndex.
[[nodiscard]] std::span<const ProfileKind> profile_kinds(bool elastic);

/// ny + 1 numbers for each profile (the last one unused for a center profile), profile by profile.
class PlaneMeans {
 public:
  PlaneMeans(bool elastic, int ny)
      : rows_(static_cast<std::size_t>(ny) + 1), values_(profile_kinds(elastic).size() * rows_) {}
  [[nodiscard]] double& operator()(ProfileIndex profile, int j) { return values_[at(profile, j)]; }
  [[nodiscard]] double operator()(ProfileIndex profile, int j) const { return values_[at(profile, j)]; }
  [[nodiscard]] std::span<double> values() { return values_; }
  [[nodiscard]] std::span<const double> values() const { return values_; }

 private:
  [[nodiscard]] std::size_t at(ProfileIndex profile, int j) const {
    return profile * rows_ + static_cast<std::size_t>(j);
  }
  std::size_t rows_;
  std::vector<double> values_;
};

/// Means over whole planes, the same on all ranks, added in the order of the ranks. Below the rows that hold
/// solid all is fluid, as for the momentum equation: the dust of phi left there is not counted. Collective;
/// ghost cells filled as advance() leaves them.
[[nodiscard]] PlaneMeans plane_means(const time::State& state, const time::Setup& setup);

}  // namespace softwall::statistics
