#include "solver/output/progress_line.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "solver/grid/cell_loop.hpp"
#include "solver/parallel/reduce.hpp"

namespace softwall::output {

namespace {

double re_tau(const time::State& state, const time::Setup& setup) {
  const auto& g = setup.grid;
  const auto u = state.velocity.x.view();
  const double sum =
      parallel::sum(setup.decomposition.all(),
                    grid::sum_cells(grid::rows(g, 0, 1), [=](int i, int j, int k) { return u(i, j, k); }));
  const double shear = sum / (double(g.nx_global) * g.nz_global) / (g.dy[0] / 2);
  return setup.physics.reynolds * std::sqrt(setup.viscosity * std::abs(shear));
}

std::string driving_and_drag(const time::State& state, const time::Setup& setup) {
  if (!is_driven_channel(setup.physics.flow)) return "";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "  P %.4e  Re_tau %.1f", state.driving_gradient,
                re_tau(state, setup));
  return text.data();
}

}  // namespace

std::string progress_line(const time::State& state, const time::Setup& setup, const Progress& progress) {
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(), "step %8lld  t %10.4f  dt %.3e (%s)%s  div %.1e  %.0f ns/cell/step",
                static_cast<long long>(state.step), state.time, progress.last_step.dt,
                progress.last_step.limit, driving_and_drag(state, setup).c_str(), progress.divergence,
                progress.ns_per_cell_step);
  return line.data();
}

}  // namespace softwall::output
