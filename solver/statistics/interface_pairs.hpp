#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "solver/statistics/interface_columns.hpp"
#include "solver/time/setup.hpp"

namespace softwall::statistics {

/// Pairs of fluctuations at the mean interface (interface_columns.hpp) whose joint distribution is summed.
struct InterfacePair {
  std::string_view first, second;  ///< of kBinnedQuantities
};
constexpr std::array<InterfacePair, 3> kInterfacePairs{{{"v", "eta"}, {"p", "eta"}, {"v", "p"}}};

/// Bins of each quantity of a pair, about 0, from -R to R: R = U_b for v, rho U_b^2 / 2 for p, the thickness
/// of the layer for eta. What lies beyond counts in the last bin on its side. A stiff wall moves a hundredth
/// of what a soft one does, so the bins grow away from 0 as sinh does, the middle one from 0.0006 R below to
/// 0.0006 R above 0. Their number is odd: whatever is at rest lies in the middle of a bin.
constexpr int kPairBins = 49;
constexpr std::array<std::string_view, 3> kBinnedQuantities{"v", "p", "eta"};

/// Numbers of a sample.
constexpr std::size_t kPairValues = kInterfacePairs.size() * kPairBins * kPairBins;

/// Bounds of the bins of a quantity, kPairBins + 1 numbers. Throws std::out_of_range for another name.
[[nodiscard]] std::vector<double> pair_bin_edges(std::string_view quantity, const grid::Grid& grid);

/// Of each pair the share of the columns in each bin, [bin of the first][bin of the second]; the same on all
/// ranks. `columns`: this rank's. Collective.
[[nodiscard]] std::vector<double> interface_pair_sample(std::span<const InterfaceColumn> columns,
                                                        const time::Setup& setup);

}  // namespace softwall::statistics
