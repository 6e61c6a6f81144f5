#pragma once

#include <span>
#include <vector>

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::statistics {

/// The interface's longest waves along the stream, moment by moment, from which its space-time spectrum
/// comes:
///   a_m = mean over the plane of (eta - mean eta) exp(-i k x),   k = 2 pi m / length_x,   m = 1 .. 8,
/// eta the height over each column (interface_height.hpp), x that of the column's middle. A wave A cos(k x -
/// w t) that spans the box has a_m = A/2 exp(-i w t).
class InterfaceModes {
 public:
  static constexpr double kInterval = 0.05;  ///< h / U_b; a moment is the first step that ends in a new one

  explicit InterfaceModes(const grid::Grid& grid);

  /// Whether the step of length dt that has just ended is one of the moments.
  [[nodiscard]] static bool is_due(const time::State& state, double dt);
  /// `heights`: over this rank's columns. Collective.
  void add(const time::State& state, std::span<const double> heights, const time::Setup& setup);

  /// Fewer than 8 where the grid has no more.
  [[nodiscard]] std::size_t modes() const { return modes_; }
  /// [moment]{time, then real and imaginary part of each mode}, h / U_b and h; the same on all ranks.
  [[nodiscard]] const std::vector<double>& rows() const { return rows_; }
  [[nodiscard]] std::size_t row_length() const { return 1 + 2 * modes_; }

  [[nodiscard]] const std::vector<double>& pack() const { return rows_; }
  /// Throws std::runtime_error when `packed` has rows of another length, and then changes nothing.
  void unpack(std::span<const double> packed);

 private:
  std::size_t modes_;
  std::vector<double> rows_;
};

}  // namespace softwall::statistics
