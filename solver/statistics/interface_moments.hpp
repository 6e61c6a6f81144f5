#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "solver/statistics/interface_columns.hpp"
#include "solver/time/setup.hpp"

namespace softwall::statistics {

/// What the interface and the flow at its mean height have in common at a moment: means over the plane of
/// products of fluctuations about the plane's mean (interface_columns.hpp).
constexpr std::array<std::string_view, 13> kInterfaceMoments{
    "eta2", "eta3", "eta4", "uu", "vv", "ww", "pp", "uv", "up", "vp", "u_eta", "v_eta", "p_eta"};

/// Bins of the height of the interface about its mean: so many, over twice the thickness of the layer. What
/// lies beyond counts in the last one on its side.
constexpr int kHeightBins = 256;

/// Bounds of the bins, h: kHeightBins + 1 numbers.
[[nodiscard]] std::vector<double> height_bin_edges(const grid::Grid& grid);

/// The moments, then the share of the columns in each bin; the same on all ranks. `columns`: this rank's.
/// Collective.
[[nodiscard]] std::vector<double> interface_sample(std::span<const InterfaceColumn> columns,
                                                   const time::Setup& setup);

}  // namespace softwall::statistics
