#include "analysis/derived.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <stdexcept>

#include "analysis/block_means.hpp"
#include "analysis/friction.hpp"
#include "analysis/jackknife.hpp"
#include "analysis/stress_balance.hpp"
#include "analysis/velocity_maximum.hpp"
#include "solver/run_directory/statistics_checks.hpp"

namespace softwall::analysis {
namespace {

constexpr double kNotDefined = std::numeric_limits<double>::quiet_NaN();
constexpr double kBalanceRemarkable = 0.2;  // stress_balance_residual beyond which the note speaks of it
constexpr double kTimeTolerance = 1e-9;     // block times are sums of many steps

/// One derivation from one set of weights: the point estimate, and each deleted batch of the jackknife.
struct Estimate {
  std::array<double, kMeasuredMembers.size()> values;  // in the order of kMeasuredMembers
  std::optional<LogLaw> log_law;
};

/// Sampled time of each block of the window, 0 outside it.
std::vector<double> window_weights(const BlockStatistics& s, const DeriveOptions& options) {
  std::vector<double> weights = s.weight;
  if (!options.window_start) return weights;
  const double limit =
      *options.window_start - kTimeTolerance * std::max(1.0, std::fabs(*options.window_start));
  for (std::size_t b = 0; b < weights.size(); ++b) {
    if (s.start[b] < limit) weights[b] = 0.0;
  }
  return weights;
}

/// U from the upper wall downward, in that wall's units. In a rigid channel the wall itself is a point, U =
/// 0.
WallProfile upper_wall_profile(const BlockStatistics& s, const std::vector<double>& u, const Friction& f,
                               double y_of_maximum) {
  WallProfile profile;
  profile.maximum_plus = (s.interface_y - y_of_maximum) * f.re_tau;
  const auto add = [&](double y, double value) {
    profile.yt_plus.push_back((s.interface_y - y) * f.re_tau);
    profile.u_plus.push_back(value / f.u_tau);
  };
  if (!s.elastic) add(s.interface_y, 0.0);
  for (std::size_t j = s.y_center.size(); j-- > 0;) add(s.y_center[j], u[j]);
  add(0.0, 0.0);
  return profile;
}

/// Where the fluid is: the maximum of U is not looked for in the solid.
VelocityMaximum fluid_maximum(const BlockStatistics& s, const std::vector<double>& u) {
  const auto end = std::upper_bound(s.y_center.begin(), s.y_center.end(), s.interface_y);
  const auto count = end - s.y_center.begin();
  return velocity_maximum({s.y_center.begin(), end}, {u.begin(), u.begin() + count});
}

double series_or_nan(const BlockStatistics& s, const std::string& name, const std::vector<double>& weights) {
  return s.series.contains(name) ? mean_series(s, name, weights) : kNotDefined;
}

/// rms of the interface height. A mean of squares where the file has it: the mean of rms values is a little
/// smaller.
double interface_rms(const BlockStatistics& s, const std::vector<double>& weights) {
  const double variance = series_or_nan(s, "interface_variance", weights);
  return std::isnan(variance) ? series_or_nan(s, "interface_rms", weights) : std::sqrt(variance);
}

/// When sampling of a block ended: its own end, or where its sampled time ends when it is clearly still being
/// filled.
double sampled_until(const BlockStatistics& s, std::size_t block) {
  const double length = s.end[block] - s.start[block];
  // Samples are some steps apart, so that a full block's weight is its length only roughly.
  return s.weight[block] < 0.9 * length ? s.start[block] + s.weight[block] : s.end[block];
}

Estimate estimate(const BlockStatistics& s, const std::vector<double>& weights,
                  const LogLawOptions& options) {
  const std::vector<double> u = mean_profile(s, "u", weights);
  const Friction f = friction({s.reynolds, mean_series(s, "driving_gradient", weights),
                               mean_series(s, "wall_shear_bottom", weights), s.interface_y});
  const VelocityMaximum top = fluid_maximum(s, u);
  LogLawOptions log_options = options;
  if (!s.elastic && !log_options.fixed_d) log_options.fixed_d = 0.0;  // a rigid wall is its own origin
  const double mean_crest = s.elastic ? series_or_nan(s, "interface_max", weights) : kNotDefined;
  log_options.low_plus =
      std::fmax(log_options.low_plus, mean_crest * f.re_tau);  // the mean flow, not the wall
  Estimate result;
  if (std::isfinite(f.re_tau)) {
    result.log_law = fit_log_law(upper_wall_profile(s, u, f, top.y), log_options);
  }
  const auto& law = result.log_law;
  result.values = {f.re_tau_w,
                   f.re_tau,
                   top.u,
                   top.y - 1.0,
                   law && s.elastic ? law->d_plus / f.re_tau : kNotDefined,
                   law ? law->k_plus_dk : kNotDefined,
                   law ? law->delta_u_plus : kNotDefined,
                   mean_crest,
                   s.elastic ? interface_rms(s, weights) : kNotDefined};
  return result;
}

void add_sentence(std::string& note, const std::string& sentence) {
  note += (note.empty() ? "" : "; ") + sentence;
}

/// Why intervals are missing, each reason once with the quantities that it holds for; all of them: no names.
std::string interval_note(const DerivedQuantities& derived, const std::vector<Interval>& intervals) {
  std::map<std::string, std::string> names_of;
  int defined = 0;
  std::map<std::string, int> count_of;
  for (std::size_t q = 0; q < intervals.size(); ++q) {
    const auto& [name, member] = kMeasuredMembers[q];
    if (std::isnan((derived.*member).value)) continue;
    ++defined;
    if (intervals[q].ci95) continue;
    std::string& names = names_of[intervals[q].reason];
    names += (names.empty() ? "" : ", ") + std::string(name);
    ++count_of[intervals[q].reason];
  }
  std::string note;
  for (const auto& [reason, names] : names_of) {
    add_sentence(note, count_of[reason] == defined ? reason : "no interval for " + names + ": " + reason);
  }
  return note;
}

void describe_window(const BlockStatistics& s, const std::vector<double>& weights,
                     DerivedQuantities& derived) {
  derived.window_start = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < weights.size(); ++b) {
    if (!(weights[b] > 0.0)) continue;
    derived.window_start = std::min(derived.window_start, s.start[b]);
    derived.window_end = sampled_until(s, b);
    derived.sampled_time += weights[b];
    ++derived.blocks;
  }
}

/// Blocks of a case may begin only where an earlier version of the program wanted its averages to.
void describe_missing_blocks(const BlockStatistics& s, DerivedQuantities& derived) {
  if (!(derived.window_asked > 0.0) || s.start.front() <= derived.window_asked * (1.0 + kTimeTolerance))
    return;
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "averages were asked for from t = %g, blocks were kept from %g",
                derived.window_asked, s.start.front());
  add_sentence(derived.note, text.data());
}

void describe_log_law(const std::optional<LogLaw>& law, DerivedQuantities& derived) {
  if (!law) {
    add_sentence(derived.note,
                 "no log law: its range is too short or holds fewer than four grid points, or no origin "
                 "makes it flat");
    return;
  }
  derived.log_range_low_plus = law->range_low_plus;
  derived.log_range_high_plus = law->range_high_plus;
  derived.log_residual = law->residual;
  derived.log_intercept = law->intercept;
}

void describe_friction(DerivedQuantities& derived) {
  if (!std::isfinite(derived.re_tau.value) || !std::isfinite(derived.re_tau_w.value)) {
    add_sentence(derived.note, "a wall shear stress is negative or not finite: not a stationary mean");
  }
}

void describe_balance(DerivedQuantities& derived) {
  if (!(derived.stress_balance_residual > kBalanceRemarkable)) return;  // also when it is not known
  const long percent = std::lround(100.0 * derived.stress_balance_residual);
  add_sentence(derived.note, "not a converged mean: the total stress departs from its straight line by " +
                                 std::to_string(percent) + " % of the wall stress");
}

void refuse(const BlockStatistics& s, const std::vector<double>& weights) {
  if (const auto found = mistakes(s); !found.empty()) {
    throw std::runtime_error("statistics are inconsistent: " + found.front());
  }
  if (std::none_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; })) {
    throw std::runtime_error("no statistics were sampled in the averaging window");
  }
}

/// A closed box or a wave leaves series only, and none of a wall.
DerivedQuantities not_a_channel(const BlockStatistics& s, const std::vector<double>& weights,
                                double window_asked) {
  DerivedQuantities derived;
  derived.window_asked = window_asked;
  describe_window(s, weights, derived);
  derived.note = "not a channel flow: its series are in statistics.h5";
  return derived;
}

}  // namespace

DerivedQuantities derive(const BlockStatistics& s, const DeriveOptions& options) {
  const std::vector<double> weights = window_weights(s, options);
  refuse(s, weights);
  if (s.profiles.empty() && !s.series.contains("wall_shear_bottom"))
    return not_a_channel(s, weights, options.window_start.value_or(0.0));
  const Estimate whole = estimate(s, weights, options.log_law);
  const std::vector<Interval> intervals = jackknife(weights, [&](const std::vector<double>& kept) {
    const auto values = estimate(s, kept, options.log_law).values;
    return std::vector<double>(values.begin(), values.end());
  });
  DerivedQuantities derived;
  derived.window_asked = options.window_start.value_or(0.0);
  describe_window(s, weights, derived);
  describe_missing_blocks(s, derived);
  for (std::size_t q = 0; q < kMeasuredMembers.size(); ++q) {
    derived.*kMeasuredMembers[q].member = {whole.values[q], intervals[q].ci95};
    if (intervals[q].ci95) {
      derived.batches =
          derived.batches == 0 ? intervals[q].batches : std::min(derived.batches, intervals[q].batches);
    }
  }
  derived.stress_balance_residual = stress_balance_residual(s, weights);
  describe_friction(derived);
  describe_balance(derived);
  describe_log_law(whole.log_law, derived);
  if (const std::string note = interval_note(derived, intervals); !note.empty())
    add_sentence(derived.note, note);
  return derived;
}

}  // namespace softwall::analysis
