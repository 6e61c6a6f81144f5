#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/case/case.hpp"
#include "solver/time/setup.hpp"
#include "solver/time/state.hpp"

/// Starting an elastic case from a rigid channel's checkpoint, on any grid and any number of ranks.
namespace softwall::output {

/// Two neighbours and the share of the second: value = (1 - share) a[low] + share a[high]. Where the point is
/// one of the source's, share is exactly 0, so that equal grids are copied bit for bit.
struct Weight {
  int low = 0, high = 0;
  double share = 0;
};

/// For `target` points of a periodic direction, both grids offset by the same fraction of their own spacing
/// (0: on faces, 1/2: on centers).
[[nodiscard]] std::vector<Weight> periodic_weights(int source, int target, double offset);

/// For heights y between or beyond the nodes (increasing); beyond them the outermost node counts.
[[nodiscard]] std::vector<Weight> height_weights(const std::vector<double>& nodes,
                                                 const std::vector<double>& y);

/// The state of an elastic case at time 0: a flat layer at rest and, in 0 < y < 2, velocity and pressure of
/// the precursor's checkpoint, each component interpolated linearly in x, y and z where it lives (zero on the
/// walls), then made solenoidal again. The pressure of the layer continues that of the fluid below it.
/// Collective. Throws AgreedError: 78 when the checkpoint is missing or of another case or box, 77 when it is
/// damaged.
[[nodiscard]] time::State start_from_precursor(const std::filesystem::path& checkpoint,
                                               const InitialSpec& initial, time::Setup& setup);

}  // namespace softwall::output
