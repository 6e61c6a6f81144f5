#include "solver/output/runaway.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "solver/grid/cell_loop.hpp"

namespace softwall::output {

bool may_be_runaway(double convection_rate, const grid::Grid& g) {
  const double widest =
      std::max({double(g.dx), double(*std::max_element(g.dy.data(), g.dy.data() + g.ny)), double(g.dz)});
  return convection_rate * widest > kFastestVelocity;
}

double fastest_here(const grid::VectorField& velocity, const grid::Grid& g) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double fastest = 0;
  for (const grid::Field* component : {&velocity.x, &velocity.y, &velocity.z}) {
    const auto q = component->view();
    fastest = std::max(fastest, grid::max_cells(grid::all_cells(g), 0.0, [=](int i, int j, int k) {
                         const double size = std::abs(q(i, j, k));
                         return size < kInfinite ? size : kInfinite;  // NaN compares false
                       }));
  }
  return fastest;
}

std::string describe_runaway(const time::State& state, double fastest) {
  std::ostringstream text;
  text << "diverged at step " << state.step << ", time " << state.time << ": ";
  if (std::isfinite(fastest)) {
    text << "a velocity reached " << fastest << " U_b";
  } else {
    text << "a velocity is not a finite number";
  }
  return text.str();
}

}  // namespace softwall::output
