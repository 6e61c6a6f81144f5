#include "solver/time/closed_box/closed_box.hpp"

#include <numbers>

#include "solver/grid/cell_loop.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/closed_box/disc.hpp"
#include "solver/time/initial.hpp"

namespace softwall::time {

namespace {

/// Solenoidal on the staggered grid: u does not depend on x, nor v on y.
void rotate(grid::VectorField& velocity, const grid::Grid& g) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const auto u = velocity.x.view(), v = velocity.y.view();
  const double* y = g.y_center.exact();
  grid::for_each_cell(grid::all_cells(g), [=, &g](int i, int j, int k) {
    u(i, j, k) = -kTurn * (y[j] - g.height / 2);
    v(i, j, k) = kTurn * ((g.x_begin + i + 0.5) * g.dx - g.length_x / 2);
  });
}

}  // namespace

State closed_box_at_start(Setup& setup) {
  State s = state_at_rest(setup);
  if (setup.solid) s.material = disc_at_rest(*setup.physics.solid->disc, setup.grid);
  if (setup.velocity_prescribed) rotate(s.velocity, setup.grid);
  start(s, setup);
  return s;
}

}  // namespace softwall::time
