#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "solver/fluid/stability.hpp"
#include "solver/time/advance.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/physics.hpp"

// Flows that depend on y alone, between no-slip walls.
namespace softwall::time {
namespace {

using support::kFaceX;

constexpr double kPi = std::numbers::pi;
/// At Re = 1 and constant flow rate the slowest transient falls as exp(-20.2 t): below round-off by then.
constexpr double kLong = 1.8;

Physics channel(int ny, double reynolds, double stretching) {
  Physics p = support::rigid_channel({1, ny, 0, 1});
  p.reynolds = reynolds;
  p.grid.stretching = stretching;
  return p;
}

void run(State& s, Setup& setup, double T, int steps) {
  start(s, setup);
  for (int step = 0; step < steps; ++step) advance(s, setup, T / steps);
}

int stable_steps(const Setup& setup, double T) {
  return static_cast<int>(std::ceil(T / (0.7 * fluid::viscosity_limit(setup.viscosity, {}, setup.grid))));
}

/// Error of the velocity of steady Poiseuille flow, and of its driving gradient 3 / Re (relative).
std::pair<double, double> poiseuille_errors(int ny, double stretching) {
  time::Setup setup(channel(ny, 1, stretching), MPI_COMM_WORLD);
  State s = state_at_rest(setup.grid, std::nullopt);  // hold_flow_rate starts it
  run(s, setup, kLong, stable_steps(setup, kLong));
  const auto parabola = [](double, double y, double) { return 1.5 * y * (2 - y); };
  EXPECT_LT(support::largest(support::global_values(s.velocity.y, setup.grid, ny, setup.decomposition.all())),
            1e-13);
  return {support::largest_error(s.velocity.x, setup.grid, kFaceX, setup.decomposition, parabola),
          std::abs(s.driving_gradient * setup.physics.reynolds / 3 - 1)};
}

TEST(Poiseuille, IsSecondOrder) {
  for (const double stretching : {0.0, 1.5}) {
    const auto coarse = poiseuille_errors(8, stretching), middle = poiseuille_errors(16, stretching),
               fine = poiseuille_errors(32, stretching);
    EXPECT_NEAR(support::observed_order(coarse.first, middle.first), 2, 0.3);
    EXPECT_NEAR(support::observed_order(middle.first, fine.first), 2, 0.1);
    EXPECT_NEAR(support::observed_order(coarse.second, middle.second), 2, 0.3);
    EXPECT_NEAR(support::observed_order(middle.second, fine.second), 2, 0.1);
    EXPECT_LT(fine.first, 2e-3);
  }
}

TEST(Poiseuille, DrivingBalancesTheWalls) {
  time::Setup setup(channel(16, 1, 1.5), MPI_COMM_WORLD);
  State s = state_at_rest(setup.grid, std::nullopt);
  run(s, setup, kLong, stable_steps(setup, kLong));
  const auto& g = setup.grid;
  const double bottom = 2 * s.velocity.x(0, 0, 0) * g.inv_dy[0],
               top = 2 * s.velocity.x(0, g.ny - 1, 0) * g.inv_dy[g.ny - 1];
  EXPECT_NEAR(s.driving_gradient * g.height, setup.viscosity * (bottom + top), 1e-11);
}

/// Stokes' second problem between walls: the lower one oscillates, u(0) = sin(w t), and
///   u = Im[ sinh(k (H - y)) / sinh(k H) exp(i w t) ],  k = sqrt(i w / nu).
double stokes_error(int ny, double stretching) {
  time::Setup setup(channel(ny, 10, stretching), MPI_COMM_WORLD);
  setup.bulk_velocity.reset();
  const double w = 1, H = setup.grid.height;
  const std::complex<double> k = std::sqrt(std::complex<double>(0, w / setup.viscosity));
  const auto at = [=](double t) {
    return [=](double, double y, double) {
      return std::imag(std::sinh(k * (H - y)) / std::sinh(k * H) * std::exp(std::complex<double>(0, w * t)));
    };
  };
  State s = state_at_rest(setup.grid, std::nullopt);
  support::set_by_position(s.velocity.x, setup.grid, kFaceX, at(0));
  start(s, setup);
  const double end = (2 * kPi + 0.8) / w;
  const int steps = stable_steps(setup, end);
  for (int n = 0; n < steps; ++n) {
    // The wall keeps the velocity of the middle of the step, an error of order dt^2 (and dt ~ dy^2).
    setup.walls.bottom_u = std::sin(w * (n + 0.5) * end / steps);
    advance(s, setup, end / steps);
  }
  return support::largest_error(s.velocity.x, setup.grid, kFaceX, setup.decomposition, at(end));
}

TEST(StokesSecondProblem, IsSecondOrder) {
  for (const double stretching : {0.0, 1.5}) {
    const std::vector<double> errors{stokes_error(16, stretching), stokes_error(32, stretching),
                                     stokes_error(64, stretching)};
    support::expect_order(stretching > 0 ? "Stokes, u, stretched grid" : "Stokes, u", errors, 1.9);
    EXPECT_LT(errors.back(), 5e-3);
  }
}

/// Error at T of u = sin(pi y / 2) exp(-nu (pi / 2)^2 t).
double decay_error(int ny, double stretching, int steps) {
  time::Setup setup(channel(ny, 5, stretching), MPI_COMM_WORLD);
  setup.bulk_velocity.reset();
  State s = state_at_rest(setup.grid, std::nullopt);
  const double k = kPi / 2, T = 2, nu = setup.viscosity;
  support::set_by_position(s.velocity.x, setup.grid, kFaceX,
                           [=](double, double y, double) { return std::sin(k * y); });
  run(s, setup, T, steps > 0 ? steps : 2 * stable_steps(setup, T));
  return support::largest_error(
      s.velocity.x, setup.grid, kFaceX, setup.decomposition,
      [=](double, double y, double) { return std::sin(k * y) * std::exp(-nu * k * k * T); });
}

TEST(DecayingShear, IsSecondOrderInSpace) {
  for (const double stretching : {0.0, 1.5}) {
    const double coarse = decay_error(8, stretching, 0), middle = decay_error(16, stretching, 0),
                 fine = decay_error(32, stretching, 0);
    EXPECT_NEAR(support::observed_order(coarse, middle), 2, 0.3);
    EXPECT_NEAR(support::observed_order(middle, fine), 2, 0.1);
  }
}

TEST(DecayingShear, IsThirdOrderInTime) {
  // On a uniform grid sin(k y) is an eigenvector of the discrete operator too, with -(2 sin(k dy/2) / dy)^2.
  const auto error = [](int steps) {
    time::Setup setup(channel(8, 2, 0), MPI_COMM_WORLD);
    setup.bulk_velocity.reset();
    State s = state_at_rest(setup.grid, std::nullopt);
    const double k = kPi / 2, T = 2, dy = setup.grid.dy[0];
    support::set_by_position(s.velocity.x, setup.grid, kFaceX,
                             [=](double, double y, double) { return std::sin(k * y); });
    run(s, setup, T, steps);
    const double rate = setup.viscosity * std::pow(2 * std::sin(k * dy / 2) / dy, 2);
    return support::largest_error(
        s.velocity.x, setup.grid, kFaceX, setup.decomposition,
        [=](double, double y, double) { return std::sin(k * y) * std::exp(-rate * T); });
  };
  EXPECT_NEAR(support::observed_order(error(40), error(80)), 3, 0.1);
}

}  // namespace
}  // namespace softwall::time
