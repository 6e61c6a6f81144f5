#include "solver/solid/transported_b/thinc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace softwall::solid {

namespace {

constexpr double kBeta = Thinc::kSharpness;

/// Root of the mean over the Gauss points b of the exact integral along the main axis,
///   1/(2 a) ln[(1 + A b E) / (1 + b E / A)],  A = e^a,
/// equal to `fraction`. The left side is concave in E, so Newton's steps rise to the root from any point left
/// of it; by Jensen's inequality the root for a single b, their mean, is such a point.
double offset_of(double fraction, double a, double A, const std::array<double, 4>& b) {
  constexpr int kMostSteps = 50;
  constexpr double kClose = 1e-9;  // relative; the step after that leaves round-off
  const double growth = std::expm1(2 * a * fraction), inv_A = 1 / A;
  const double single = growth / (A - inv_A - growth * inv_A);
  double E = 4 * single / (b[0] + b[1] + b[2] + b[3]);
  for (int step = 0; step < kMostSteps; ++step) {
    double ratio = 1, slope = 0;
    for (const double at : b) {
      const double upper = 1 + A * at * E, lower = 1 + at * inv_A * E, both = 1 / (upper * lower);
      ratio *= upper * upper * both;
      slope += at * (A - inv_A) * both;
    }
    const double change = (8 * a * fraction - std::log(ratio)) / slope;
    E += change;
    if (std::abs(change) <= kClose * E) break;
  }
  return E;
}

}  // namespace

Thinc::Thinc(double fraction, const std::array<double, 3>& gradient)
    : complement_(fraction > 0.5), main_(0), normal_(gradient), gauss_{1, 1, 1} {
  const double size = std::hypot(gradient[0], gradient[1], gradient[2]);
  for (double& component : normal_) component *= (complement_ ? -1 : 1) / size;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(normal_[axis]) > std::abs(normal_[main_])) main_ = axis;
  }
  slope_ = kBeta * std::abs(normal_[main_]);
  half_ = std::exp(slope_);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != main_) gauss_[axis] = std::exp(kBeta * normal_[axis] * std::numbers::inv_sqrt3);
  }
  const double one = gauss_[(main_ + 1) % 3], other = gauss_[(main_ + 2) % 3];
  offset_ = offset_of(complement_ ? 1 - fraction : fraction, slope_, half_,
                      {one * other, one / other, other / one, 1 / (one * other)});
}

double Thinc::on_face(int axis, bool high) const {
  const double mean = axis == main_ ? across(high) : along(axis, high);
  return complement_ ? 1 - mean : mean;
}

/// On a face at an end of the main axis: four Gauss points.
double Thinc::across(bool high) const {
  const double E = (high == (normal_[main_] > 0) ? half_ : 1 / half_) * offset_;
  const double one = gauss_[(main_ + 1) % 3], other = gauss_[(main_ + 2) % 3];
  double sum = 0;
  for (const double at : {one * other, one / other, other / one, 1 / (one * other)})
    sum += at * E / (1 + at * E);
  return sum / 4;
}

/// On a face at an end of another axis: two Gauss points, each with the exact integral along the main axis.
double Thinc::along(int side_axis, bool high) const {
  const double E = std::exp((high ? kBeta : -kBeta) * normal_[side_axis]) * offset_;
  const double remaining = gauss_[3 - main_ - side_axis];
  double ratio = 1;
  for (const double at : {remaining, 1 / remaining}) ratio *= (1 + half_ * at * E) / (1 + at * E / half_);
  return std::log(ratio) / (4 * slope_);
}

}  // namespace softwall::solid
