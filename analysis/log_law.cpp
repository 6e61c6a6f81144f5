#include "analysis/log_law.hpp"

#include <cmath>

#include "analysis/cubic_spline.hpp"

// Xi(yt+; d) = (yt + d)+ dU+/dyt+ = a + d+ b with a = yt+ dU+/dyt+ and b = dU+/dyt+, so the least-squares
// slope of Xi over the range is linear in d+: slope(a) + d+ slope(b) = 0 has one solution, and no search is
// needed. The range is counted from the wall, not from the shifted origin, exactly so that this holds.
namespace softwall::analysis {
namespace {

constexpr int kSamples = 200;    // the integrals over the range, by the midpoint rule
constexpr int kLeastPoints = 4;  // of the profile inside the range
// A shorter range has a "flat" Xi for any profile: a laminar one (maximum at yt+ = 92) has to fail here.
constexpr double kLeastLength = 1.5;  // upper end over lower end

struct Range {
  double low = 0.0, high = 0.0;
  [[nodiscard]] double at(int sample) const { return low + (high - low) * (sample + 0.5) / kSamples; }
};

/// Least-squares slope of samples over the range.
double slope(const Range& range, const std::vector<double>& samples) {
  const double middle = 0.5 * (range.low + range.high);
  double covariance = 0.0, variance = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double x = range.at(i) - middle;
    covariance += x * samples[i];
    variance += x * x;
  }
  return covariance / variance;
}

int points_within(const std::vector<double>& yt_plus, const Range& range) {
  int count = 0;
  for (const double y : yt_plus) count += (y >= range.low && y <= range.high) ? 1 : 0;
  return count;
}

double flattening_shift(const Range& range, const std::vector<double>& shear) {
  std::vector<double> moment(kSamples);
  for (int i = 0; i < kSamples; ++i) moment[i] = range.at(i) * shear[i];
  return -slope(range, moment) / slope(range, shear);
}

/// Everything that follows once the origin is chosen.
LogLaw fit_with_origin(double d_plus, const Range& range, const CubicSpline& u,
                       const std::vector<double>& shear) {
  LogLaw law;
  law.d_plus = d_plus;
  law.range_low_plus = range.low;
  law.range_high_plus = range.high;
  double mean = 0.0, mean_square = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double xi = (range.at(i) + d_plus) * shear[i];
    mean += xi / kSamples;
    mean_square += xi * xi / kSamples;
  }
  law.k_plus_dk = 1.0 / mean;
  law.residual = std::sqrt(std::fmax(mean_square - mean * mean, 0.0)) / mean;
  for (int i = 0; i < kSamples; ++i) {
    law.intercept += (u.value(range.at(i)) - std::log(range.at(i) + d_plus) * mean) / kSamples;
  }
  law.delta_u_plus = kAdditiveConstant - law.intercept;
  return law;
}

}  // namespace

std::optional<LogLaw> fit_log_law(const WallProfile& profile, const LogLawOptions& options) {
  const Range range{options.low_plus, options.high_fraction * profile.maximum_plus};
  const int points = points_within(profile.yt_plus, range);
  if (!(range.high >= kLeastLength * range.low) || points < kLeastPoints) return std::nullopt;
  const CubicSpline u(profile.yt_plus, profile.u_plus);
  std::vector<double> shear(kSamples);
  for (int i = 0; i < kSamples; ++i) shear[i] = u.slope(range.at(i));
  const double d_plus = options.fixed_d ? *options.fixed_d : flattening_shift(range, shear);
  if (!(std::fabs(d_plus) < profile.maximum_plus) || !(range.low + d_plus > 0.0)) return std::nullopt;
  LogLaw law = fit_with_origin(d_plus, range, u, shear);
  law.points = points;
  if (!(law.k_plus_dk > 0.0)) return std::nullopt;
  return law;
}

}  // namespace softwall::analysis
