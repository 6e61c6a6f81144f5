#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/case/case.hpp"

/// Where the cells end in y. Fluid, 0 <= y <= 2, stretching s > 0:
///     y_f(j) = 1 + tanh(s (2 j / ny_fluid - 1)) / tanh(s)          (s = 0: uniform)
/// Layer, 2 <= y <= 2 + h_e: spacings a r, a r^2, ..., a r^ny_solid with a the last fluid spacing and the
/// growth r such that they sum to h_e. So the spacing is smooth across the interface when r is near 1.
namespace softwall {

/// Of the fluid of a channel, h; the interface at rest lies there.
inline constexpr double kFluidHeight = 2;

/// Growths outside this range would spoil the accuracy of the differences at the interface.
inline constexpr double kLeastGrowth = 0.8, kMostGrowth = 1.25;

/// Nor may the layer's last spacing be less than this part of the last one in the fluid: it would cost time
/// steps and resolve nothing.
inline constexpr double kLeastSpacingRatio = 0.25;

/// The ny + 1 faces, from 0 to 2 + layer_height (2 for ny_solid = 0); the faces at 0, 2 and the top are
/// exact.
[[nodiscard]] std::vector<double> wall_normal_faces(const GridSpec& grid, double layer_height);

/// The faces of any case: those above for a channel, uniform ones from 0 to the height of a closed box.
[[nodiscard]] std::vector<double> wall_normal_faces(const Physics& physics);

/// The growth r > 0 for which `cells` spacings, the first r * last_fluid_spacing, sum to layer_height.
[[nodiscard]] double layer_growth(double last_fluid_spacing, double layer_height, int cells);

/// Empty when fluid and layer spacing fit at the interface; otherwise what is wrong and which ny_solid would
/// do. Uniform grid: equal spacing to 1e-9; stretched grid: growth and spacing within the limits above.
[[nodiscard]] std::string interface_spacing_problem(const GridSpec& grid, double layer_height);

}  // namespace softwall
