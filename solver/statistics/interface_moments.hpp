#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

namespace softwall::statistics {

/// What the interface and the flow at its mean height have in common at a moment: means over the plane of
/// products of fluctuations about the plane's mean. eta is the height of the interface
/// (interface_height.hpp); u, v, w, p stand at the height of the flat interface over the middle of each
/// column, v as it is on the face there, the others as means of their neighbours, between the rows on both
/// sides linear in y.
constexpr std::array<std::string_view, 13> kInterfaceMoments{
    "eta2", "eta3", "eta4", "uu", "vv", "ww", "pp", "uv", "up", "vp", "u_eta", "v_eta", "p_eta"};

/// Bins of the height of the interface about its mean: so many, over twice the thickness of the layer. What
/// lies beyond counts in the last one on its side.
constexpr int kHeightBins = 256;

/// Bounds of the bins, h: kHeightBins + 1 numbers.
[[nodiscard]] std::vector<double> height_bin_edges(const grid::Grid& grid);

/// The moments, then the share of the columns in each bin; the same on all ranks. `heights`: over this rank's
/// columns. Collective; ghost cells filled.
[[nodiscard]] std::vector<double> interface_sample(const time::State& state, std::span<const double> heights,
                                                   const time::Setup& setup);

}  // namespace softwall::statistics
