#include "solver/time/laminar_mean.hpp"

#include <algorithm>

namespace softwall::time {

LaminarMean::LaminarMean(const Setup& setup)
    : G_(setup.physics.solid->G),
      u_(static_cast<std::size_t>(setup.grid.ny), 0.0),
      displacement_(static_cast<std::size_t>(setup.grid.ny), 0.0) {
  const auto& g = setup.grid;
  const auto at = [](int row) { return static_cast<std::size_t>(row); };
  // A wall lies half a spacing away from the row beside it.
  u_[0] = (1 - g.y_face[0]) / setup.viscosity * g.dy_face[0] / 2;
  for (int j = 1; j < g.ny_fluid; ++j)
    u_[at(j)] = u_[at(j - 1)] + (1 - g.y_face[j]) / setup.viscosity * g.dy_face[j];
  double flow = 0;
  for (int j = 0; j < g.ny_fluid; ++j) flow += u_[at(j)] * g.dy[j];
  gradient_ = g.y_face[g.ny_fluid] / flow;
  for (int j = 0; j < g.ny_fluid; ++j) u_[at(j)] *= gradient_;

  displacement_[at(g.ny - 1)] = -shear(g.y_face[g.ny]) * g.dy_face[g.ny] / 2;
  const double interface = g.y_face[g.ny_fluid];
  for (int j = g.ny - 1; j > 0; --j)
    displacement_[at(j - 1)] = displacement_[at(j)] - shear(std::max(g.y_face[j], interface)) * g.dy_face[j];
}

}  // namespace softwall::time
