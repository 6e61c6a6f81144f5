#pragma once

#include <array>

/// The interface within one cell as a smoothed step, the multi-dimensional THINC of Ii, Sugiyama, Takeuchi,
/// Takagi, Matsumoto & Xiao, J. Comput. Phys. 231 (2012), with a plane:
///   H(xi) = (1 + tanh(beta (n . xi + d))) / 2,   -1/2 <= xi_m <= 1/2 across the cell, |n| = 1,
/// where d makes the mean of H over the cell equal its fraction. Faces are averaged as Xie & Xiao, J. Comput.
/// Phys. 349 (2017) do for schemes that are discrete in space only. Along the axis of the largest component
/// of n integrals are exact, along the others they are Gauss's with two points.
namespace softwall::solid {

class Thinc {
 public:
  /// beta: 10 to 90 % of the step take 2.2 / beta cells.
  static constexpr double kSharpness = 2;

  /// fraction: 0 < fraction < 1; gradient: of the fraction, differences from cell to cell, not all zero.
  Thinc(double fraction, const std::array<double, 3>& gradient);

  /// Mean of H over the face at xi_axis = -1/2, or at +1/2 when `high`; axis 0, 1, 2: x, y, z.
  [[nodiscard]] double on_face(int axis, bool high) const;

 private:
  [[nodiscard]] double across(bool high) const;
  [[nodiscard]] double along(int side_axis, bool high) const;

  // With E = e^(2 beta d) the step is e E / (1 + e E), e = e^(2 beta n . xi). More than half a cell of solid
  // is treated as its complement of fluid, so that E is never large.
  bool complement_;
  int main_;                      ///< axis of the largest |n|
  std::array<double, 3> normal_;  ///< of the complement where that is treated
  double slope_;                  ///< a = beta |n_main|
  double half_;                   ///< e^a: e at the end of the main axis where H is larger
  std::array<double, 3> gauss_;   ///< e at the upper Gauss point of each other axis; 1 / e at the lower one
  double offset_;                 ///< E
};

}  // namespace softwall::solid
