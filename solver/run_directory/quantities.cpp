#include "solver/run_directory/quantities.hpp"

#include <map>

namespace softwall::analysis {

const Meaning* known_meaning(const std::string& name) {
  // Second moments are raw, <u u> and not <u'u'>: raw moments of blocks can be averaged, central ones cannot.
  static const std::map<std::string, Meaning> kKnown = {
      {"y_center", {"h", "wall-normal position of the cell centers"}},
      {"y_face", {"h", "wall-normal position of the cell faces, walls included"}},
      {"start", {"h/U_b", "time at which the block starts"}},
      {"end", {"h/U_b", "time at which the block ends"}},
      {"weight", {"h/U_b", "time sampled within the block"}},
      {"u", {"U_b", "mean streamwise velocity"}},
      {"v", {"U_b", "mean wall-normal velocity"}},
      {"w", {"U_b", "mean spanwise velocity"}},
      {"uu", {"U_b^2", "raw second moment <u u>"}},
      {"vv", {"U_b^2", "raw second moment <v v>"}},
      {"ww", {"U_b^2", "raw second moment <w w>"}},
      {"p", {"rho U_b^2", "mean pressure"}},
      {"pp", {"rho^2 U_b^4", "raw second moment <p p>"}},
      {"phi", {"1", "mean solid fraction"}},
      {"uv", {"U_b^2", "momentum flux <u v> as the scheme transports it"}},
      {"viscous_stress",
       {"rho U_b^2", "mean viscous shear stress <mu (du/dy + dv/dx)> as the scheme counts it"}},
      {"elastic_stress",
       {"rho U_b^2",
        "mean elastic shear stress (G B_xy of a neo-Hookean solid) times the share of the solid, as the "
        "scheme counts it"}},
      {"driving_gradient", {"rho U_b^2/h", "pressure gradient P that drives the flow"}},
      {"wall_shear_bottom", {"U_b^2", "nu dU/dy at y = 0"}},
      {"wall_shear_top", {"U_b^2", "-nu dU/dy at the upper end of the channel"}},
      {"interface_mean", {"h", "plane mean of the interface height eta"}},
      {"interface_rms", {"h", "plane rms of eta about its plane mean"}},
      {"interface_variance", {"h^2", "plane variance of eta about its plane mean"}},
      {"interface_max", {"h", "plane maximum of |eta - mean eta|, averaged in time"}},
      {"interface_peak", {"h", "maximum over the block of the plane maximum of |eta - mean eta|"}},
  };
  const auto found = kKnown.find(name);
  return found == kKnown.end() ? nullptr : &found->second;
}

const Meaning* meaning_of(const BlockStatistics& statistics, const std::string& name) {
  const auto found = statistics.meanings.find(name);
  return found == statistics.meanings.end() ? known_meaning(name) : &found->second;
}

}  // namespace softwall::analysis
