#include "solver/pressure/closed_box/box_solver.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/pressure/projection.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/order.hpp"
#include "tests/support/physics.hpp"

namespace softwall::pressure {
namespace {

using support::cavity;
constexpr double kPi = std::numbers::pi;

/// A box with the quantity in it; `q` gets one ghost layer by the quantity's own boundary condition.
struct Box {
  Box(int nx, int ny, BoxQuantity what)
      : setup(cavity(nx, ny), MPI_COMM_WORLD),
        quantity(what),
        solver(setup.grid, setup.decomposition, what),
        q(setup.grid, 1) {}

  [[nodiscard]] bool used(int i, int j) const {
    return !(quantity == BoxQuantity::kU && setup.grid.x_begin + i == 0) &&
           !(quantity == BoxQuantity::kV && j == 0);
  }

  template <class Value>
  void solve(Real shift, const Value& right_side) {
    const auto& g = setup.grid;
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i)
        solver.values()[j * g.nx + i] = used(i, j) ? right_side(g.x_begin + i, j) : 0;
    }
    solver.solve(shift);
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) q(i, j, 0) = used(i, j) ? solver.values()[j * g.nx + i] : 0;
    }
    fill_ghosts();
  }

  void fill_ghosts() {
    const auto& g = setup.grid;
    if (quantity == BoxQuantity::kPressure) return fluid::fill_ghosts(q, setup.halo);
    grid::VectorField all(g, 1);
    support::copy(q, quantity == BoxQuantity::kU ? all.x : all.y);
    fluid::fill_ghosts(all, fluid::walls_of(g), setup.halo);
    support::copy(quantity == BoxQuantity::kU ? all.x : all.y, q);
  }

  /// The difference operator, written out.
  [[nodiscard]] double laplacian(int i, int j) const {
    const double h = setup.grid.dx, hy = setup.grid.dy[0];
    return (q(i + 1, j, 0) - 2 * q(i, j, 0) + q(i - 1, j, 0)) / (h * h) +
           (q(i, j + 1, 0) - 2 * q(i, j, 0) + q(i, j - 1, 0)) / (hy * hy);
  }

  time::Setup setup;
  BoxQuantity quantity;
  BoxSolver solver;
  grid::Field q;
};

class BoxSolverFor : public testing::TestWithParam<BoxQuantity> {};

TEST_P(BoxSolverFor, SatisfiesTheDifferenceEquationToRoundOff) {
  for (const auto& [nx, ny] : {std::pair{18, 12}, {19, 7}, {24, 25}}) {
    for (const double shift : {0.0, 3.0, 1e5}) {
      Box box(nx, ny, GetParam());
      const double mean = [&] {  // a pressure needs a right-hand side without mean
        double sum = 0;
        for (int j = 0; j < ny; ++j) {
          for (int i = 0; i < nx; ++i) sum += support::noise(3, i, j, 0);
        }
        return GetParam() == BoxQuantity::kPressure && shift == 0 ? sum / (nx * ny) : 0;
      }();
      const auto right_side = [&](int i, int j) { return support::noise(3, i, j, 0) - mean; };
      box.solve(shift, right_side);
      const auto& g = box.setup.grid;
      for (int j = 0; j < g.ny; ++j) {
        for (int i = 0; i < g.nx; ++i) {
          if (!box.used(i, j)) continue;
          EXPECT_NEAR(box.laplacian(i, j) - shift * box.q(i, j, 0), right_side(g.x_begin + i, j), 2e-11);
        }
      }
    }
  }
}

TEST_P(BoxSolverFor, ConvergesToTheSolutionWithSecondOrder) {
  const bool cosine = GetParam() == BoxQuantity::kPressure;
  const auto exact = [=](double x, double y) {
    return cosine ? std::cos(2 * kPi * x) * std::cos(3 * kPi * y)
                  : std::sin(2 * kPi * x) * std::sin(3 * kPi * y);
  };
  const double kappa2 = 13 * kPi * kPi, shift = cosine ? 0 : 7;
  std::vector<double> errors;
  for (const int n : {24, 48}) {
    Box box(n, n, GetParam());
    const auto& g = box.setup.grid;
    const double to_x = GetParam() == BoxQuantity::kU ? 0 : 0.5,
                 to_y = GetParam() == BoxQuantity::kV ? 0 : 0.5;
    const auto at = [&](int i, int j) { return exact((i + to_x) * g.dx, (j + to_y) * g.dx); };
    box.solve(shift, [&](int i, int j) { return -(kappa2 + shift) * at(i, j); });
    double worst = 0;
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i) {
        if (box.used(i, j)) worst = support::worse(worst, std::abs(box.q(i, j, 0) - at(g.x_begin + i, j)));
      }
    }
    errors.push_back(support::worst(box.setup.decomposition.all(), worst));
  }
  EXPECT_GT(errors[0], 1e-4);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Quantities, BoxSolverFor,
                         testing::Values(BoxQuantity::kPressure, BoxQuantity::kU, BoxQuantity::kV));

TEST(BoxSolver, ThePressureHasNoMean) {
  Box box(18, 12, BoxQuantity::kPressure);
  box.solve(0, [](int i, int j) { return std::cos(kPi * (i + 0.5) / 18) + std::cos(kPi * (j + 0.5) / 12); });
  const auto all = support::global_values(box.q, box.setup.grid, 12, box.setup.decomposition.all());
  double sum = 0;
  for (const double value : all) sum += value;
  EXPECT_NEAR(sum, 0, 1e-12 * support::largest(all) * double(all.size()));
}

TEST(BoxSolver, RefusesADeepBox) {
  Physics p = support::rigid_channel({12, 8, 0, 6});
  const time::Setup setup(p, MPI_COMM_WORLD);
  EXPECT_THROW(BoxSolver(setup.grid, setup.decomposition, BoxQuantity::kU), std::invalid_argument);
}

TEST(BoxProjection, RandomVelocityHasNoDivergenceLeft) {
  time::Setup setup(cavity(20, 14), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  grid::VectorField q(g, 1);
  grid::Field pressure(g, 1);
  support::set_by_index(q.x, g, g.ny, [](int i, int j, int k) { return support::noise(1, i, j, k); });
  support::set_by_index(q.y, g, g.ny, [](int i, int j, int k) { return support::noise(2, i, j, k); });
  fluid::fill_ghosts(q, setup.walls, setup.halo);
  ASSERT_GT(max_divergence(q, g, setup.decomposition), 1);
  setup.box_projection->project(q, pressure, kRungeKutta3[1], 0.01);
  fluid::fill_ghosts(q, setup.walls, setup.halo);
  EXPECT_LT(max_divergence(q, g, setup.decomposition), 1e-12 / g.dx);
}

}  // namespace
}  // namespace softwall::pressure
