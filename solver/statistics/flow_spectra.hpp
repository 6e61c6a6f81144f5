#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "solver/pressure/poisson.hpp"
#include "solver/time/state.hpp"

namespace softwall::statistics {

/// One-dimensional power spectra along x and along z, at every height, of
///   u, w, p in the rows of cells, v on the faces 0 .. ny - 1;
/// and of the height of the interface, which takes the row of v that lies on the lower wall, where v is 0.
/// With q^ (m, n) the Fourier coefficient of q in a row of nx x nz columns, divided by nx nz,
///   E_x(m) = sum over n of |q^(m, n)|^2 + |q^(-m, n)|^2 (the latter but for m = 0 and nx / 2),
/// and E_z in the same way with x and z exchanged, so that the sum over all m of either is the mean square of
/// q. The mean over the plane at the moment, q^(0, 0), is left out. On a periodic grid the correlation of q
/// is the cosine transform of E, exactly.
///
/// Every rank holds a part of the spectra: those of its modes in x, and a share of the modes in z, in its
/// rows.
class FlowSpectra {
 public:
  static constexpr std::array<std::string_view, 4> kFields{"u", "v", "w", "p"};

  /// All refer to what they are given for as long as they live. Collective.
  FlowSpectra(const grid::Grid& grid, const parallel::Decomposition& decomposition);

  /// Numbers of this rank's part, and of the whole.
  [[nodiscard]] std::size_t part_size() const { return own_.size(); }
  [[nodiscard]] std::size_t whole_size() const;

  /// Modes along x and along z.
  [[nodiscard]] std::array<int, 2> modes() const;

  /// This rank's part of the spectra of a moment. `heights`: of the interface over this rank's columns, h
  /// (interface_height.hpp); may be empty. Collective.
  [[nodiscard]] std::vector<double> part_of(const time::State& state, std::span<const double> heights,
                                            pressure::Poisson& transforms) const;

  /// [axis x, z][field][mode][row] from the parts of all ranks, on rank 0; empty elsewhere. Collective.
  [[nodiscard]] std::vector<double> whole(std::span<const double> part) const;
  /// This rank's part of it.
  [[nodiscard]] std::vector<double> part(std::span<const double> whole) const;

 private:
  /// The modes and rows of a rank, half open: for each axis {mode begin, mode end}, then {row begin, row
  /// end}.
  struct Share {
    std::array<int, 6> bounds{};
    [[nodiscard]] parallel::Range modes(std::size_t axis) const {
      return {bounds[2 * axis], bounds[2 * axis + 1]};
    }
    [[nodiscard]] parallel::Range rows() const { return {bounds[4], bounds[5]}; }
    [[nodiscard]] std::size_t size() const;
  };
  template <class Visit>
  void for_each_row(const Share& share, const Visit& visit) const;
  [[nodiscard]] Share share_of(const parallel::Decomposition& decomposition) const;
  [[nodiscard]] std::vector<double> summed_over_x(const std::vector<double>& spectrum_z) const;

  const grid::Grid& grid_;
  const parallel::Decomposition& decomposition_;
  Share own_;
  std::vector<Share> shares_;  ///< of all ranks
};

}  // namespace softwall::statistics
