#pragma once

#include <optional>
#include <vector>

/// The logarithmic law at the upper wall, U+ = ln((yt + d)+) / (k + Dk) + B - DU+, yt = 2 - y (the paper,
/// eq:log-law-mod), fitted by an objective rule: analysis/README.md says which and how sensitive it is.
namespace softwall::analysis {

inline constexpr double kAdditiveConstant =
    5.5;  ///< B of the paper at this Reynolds number (below eq:log-law)

/// U(y) between the upper wall and beyond the maximum of U, seen from the upper wall, in that wall's own
/// units.
struct WallProfile {
  std::vector<double> yt_plus;  ///< distance from the wall, increasing
  std::vector<double> u_plus;
  double maximum_plus = 0.0;  ///< yt+ of the maximum of U
};

struct LogLawOptions {
  double low_plus = 37.0;         ///< the equilibrium range starts at this yt+, or at the mean crest ...
  double high_fraction = 0.5;     ///< ... and ends at this fraction of the distance to the maximum of U
  std::optional<double> fixed_d;  ///< [wall units] keep the origin here instead of searching (rigid wall: 0)
};

struct LogLaw {
  double d_plus = 0.0;
  double k_plus_dk = 0.0;
  double intercept = 0.0;  ///< B - DU+
  double delta_u_plus = 0.0;
  double range_low_plus = 0.0, range_high_plus = 0.0;  ///< as yt+
  double residual = 0.0;  ///< rms of Xi about its mean over the range, divided by the mean
  int points = 0;
};

/// Empty when the range is too short or holds fewer than four points of the profile, or when no d with |d+| <
/// maximum_plus that keeps (yt + d)+ positive makes Xi flat.
[[nodiscard]] std::optional<LogLaw> fit_log_law(const WallProfile& profile,
                                                const LogLawOptions& options = {});

}  // namespace softwall::analysis
