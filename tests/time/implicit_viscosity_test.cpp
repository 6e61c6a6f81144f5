#include "solver/time/closed_box/implicit_viscosity.hpp"

#include <gtest/gtest.h>

#include "solver/time/advance.hpp"
#include "solver/time/closed_box/closed_box.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"

namespace softwall::time {
namespace {

constexpr double kViscosity = 0.01, kDt = 0.3;
const Stage& stage = kRungeKutta3[0];

void fill_with_noise(grid::VectorField& q, time::Setup& setup, int seed) {
  const auto& g = setup.grid;
  support::set_by_index(q.x, g, g.ny, [=](int i, int j, int k) { return support::noise(seed, i, j, k); });
  support::set_by_index(q.y, g, g.ny, [=](int i, int j, int k) { return support::noise(seed + 1, i, j, k); });
  fluid::fill_ghosts(q, setup.walls, setup.halo);
}

double laplacian(const grid::Field& q, const grid::Grid& g, int i, int j) {
  const double h = g.dx, hy = g.dy[0];
  return (q(i + 1, j, 0) - 2 * q(i, j, 0) + q(i - 1, j, 0)) / (h * h) +
         (q(i, j + 1, 0) - 2 * q(i, j, 0) + q(i, j - 1, 0)) / (hy * hy);
}

/// u* = u^ + a laplacian(u* + u), the lid included, for any a; far beyond what an explicit step could bear.
TEST(ImplicitViscosity, IsCrankNicolsonToRoundOff) {
  time::Setup setup(support::cavity(18, 14), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  grid::VectorField old(g, 1), predicted(g, 1), now(g, 1);
  fill_with_noise(old, setup, 1);
  fill_with_noise(predicted, setup, 5);
  support::copy(predicted, now);
  ImplicitViscosity viscosity(g, setup.decomposition, kViscosity);
  viscosity.keep(old, stage, kDt);
  viscosity.apply(now, stage, kDt);
  fluid::fill_ghosts(now, setup.walls, setup.halo);
  const double a = stage.alpha * kDt * kViscosity;
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      if (g.x_begin + i > 0) {
        EXPECT_NEAR(now.x(i, j, 0) - a * (laplacian(now.x, g, i, j) + laplacian(old.x, g, i, j)),
                    predicted.x(i, j, 0), 1e-12);
      }
      if (j > 0) {
        EXPECT_NEAR(now.y(i, j, 0) - a * (laplacian(now.y, g, i, j) + laplacian(old.y, g, i, j)),
                    predicted.y(i, j, 0), 1e-12);
      }
    }
  }
}

/// The two ways to treat viscosity are two discretisations of one flow.
TEST(ImplicitViscosity, LeadsWhereExplicitViscosityLeads) {
  Physics p = support::cavity(24, 24);
  const auto after = [](const Physics& physics, int steps) {
    time::Setup setup(physics, MPI_COMM_WORLD);
    time::State s = time::closed_box_at_start(setup);
    for (int n = 0; n < steps; ++n) time::advance(s, setup, 0.4 / steps);
    return support::global_values(s.velocity.x, setup.grid, setup.grid.ny, setup.decomposition.all());
  };
  const auto exact = after(p, 400);
  p.time_step.viscosity = ViscousTerms::kImplicit;
  const double coarse = support::largest_difference(after(p, 50), exact),
               fine = support::largest_difference(after(p, 100), exact);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, 0.6 * coarse);
}

}  // namespace
}  // namespace softwall::time
