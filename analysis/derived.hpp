#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/log_law.hpp"
#include "solver/run_directory/block_statistics.hpp"

/// The numbers of the paper's tables 1 and 2, with their uncertainty. Definitions: analysis/README.md.
namespace softwall::analysis {

/// Stored with every result; raised whenever a change here changes a number, so that results are derived
/// anew.
inline constexpr int kAnalysisVersion = 4;

struct Measured {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not defined for this case
  std::optional<double> ci95;  ///< half width of the 95 % confidence interval; empty: the window gives none
};

struct DerivedQuantities {
  Measured re_tau_w;      ///< friction Reynolds number of the bottom (rigid) wall
  Measured re_tau;        ///< of the upper wall: elastic, or rigid in a rigid channel
  Measured u_max;         ///< maximum of the mean velocity [U_b]
  Measured y_max;         ///< where it is, counted from y = 1, negative toward the bottom wall [h]
  Measured d;             ///< shift of the origin of the log law [h]; NaN in a rigid channel, where it is 0
  Measured k_plus_dk;     ///< inverse slope of the log law at the upper wall
  Measured delta_u_plus;  ///< its downward shift, with kAdditiveConstant
  Measured delta_max;     ///< mean of the plane maximum of |eta - mean eta| [h]; NaN in a rigid channel
  Measured delta_rms;     ///< rms of the interface height about its mean [h]; NaN in a rigid channel

  double window_asked = 0.0;  ///< where the window was to start; 0: with the first block [h/U_b]
  double window_start = 0.0, window_end = 0.0;  ///< [h/U_b]
  double sampled_time = 0.0;                    ///< sum of the weights [h/U_b]
  int blocks = 0;                               ///< statistics blocks used
  int batches = 0;  ///< groups of blocks that the intervals rest on; 0: no intervals

  double log_range_low_plus = 0.0, log_range_high_plus = 0.0;  ///< equilibrium range used, as yt+
  double log_residual = 0.0;   ///< rms of Xi about its mean over the range, divided by the mean
  double log_intercept = 0.0;  ///< U+ = ln((yt + d)+) / k_plus_dk + log_intercept

  /// rms over the height of total stress - (u_tau_w^2 - P y), divided by u_tau_w^2: 0 in a converged
  /// mean
  double stress_balance_residual = std::numeric_limits<double>::quiet_NaN();

  std::string note;  ///< in words: why there is no interval, no log law, ...; empty when all is well
};

/// Name (as in the results table) and place of every measured quantity, in the order of the paper's tables.
struct MeasuredMember {
  std::string_view name;
  Measured DerivedQuantities::*member;
};
inline constexpr std::array<MeasuredMember, 9> kMeasuredMembers = {{
    {"re_tau_w", &DerivedQuantities::re_tau_w},
    {"re_tau", &DerivedQuantities::re_tau},
    {"u_max", &DerivedQuantities::u_max},
    {"y_max", &DerivedQuantities::y_max},
    {"d", &DerivedQuantities::d},
    {"k_plus_dk", &DerivedQuantities::k_plus_dk},
    {"delta_u_plus", &DerivedQuantities::delta_u_plus},
    {"delta_max", &DerivedQuantities::delta_max},
    {"delta_rms", &DerivedQuantities::delta_rms},
}};

struct DeriveOptions {
  std::optional<double>
      window_start;  ///< use only blocks that start at or after this time; default: all stored
  LogLawOptions log_law;
};

/// All of the above from the blocks of one case. Statistics without profiles and wall shear are those of a
/// closed box or a wave, of which only the window is described. A quantity that cannot be had (no log range,
/// no interface in the file) is NaN and the note says why. Throws std::runtime_error when nothing at all can
/// be derived: no block in the window, inconsistent statistics, or a required profile or series missing (u;
/// driving_gradient, wall_shear_bottom).
[[nodiscard]] DerivedQuantities derive(const BlockStatistics& statistics, const DeriveOptions& options = {});

}  // namespace softwall::analysis
