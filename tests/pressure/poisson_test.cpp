#include "solver/pressure/poisson.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/fields.hpp"
#include "tests/support/order.hpp"
#include "tests/support/round_off.hpp"

namespace softwall::pressure {
namespace {

using support::Domain;

/// Between two fields; counts in `visits` a given row as 1, one taken as 10.
class BetweenFields final : public PoissonRows {
 public:
  BetweenFields(const grid::Field& right_side, grid::Field& psi, grid::Field& visits)
      : right_side_(right_side), psi_(psi), visits_(visits) {}
  void give_right_side(int j, int k, Real* row) override {
    for (int i = 0; i < psi_.nx(); ++i) row[i] = right_side_(i, j, k);
    visits_(0, j, k) += 1;
  }
  void take_solution(int j, int k, const Real* row) override {
    for (int i = 0; i < psi_.nx(); ++i) psi_(i, j, k) = row[i];
    visits_(0, j, k) += 10;
  }

 private:
  const grid::Field& right_side_;
  grid::Field &psi_, &visits_;
};

grid::Field solve(Domain& d, const grid::Field& rhs) {
  const auto& g = d.grid;
  Poisson poisson(g, d.decomposition);
  grid::Field psi(g, 1), visits(g, 0);
  BetweenFields rows(rhs, psi, visits);
  poisson.solve(rows);
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) EXPECT_EQ(visits(0, j, k), 11) << "row " << j << ", " << k;
  }
  fluid::fill_ghosts(psi, d.halo);  // zero gradient at the walls
  return psi;
}

/// The discrete operator, written out as poisson.hpp states it.
Real laplacian(const grid::Field& q, const Grid& g, int i, int j, int k) {
  const Real x = (q(i + 1, j, k) - 2 * q(i, j, k) + q(i - 1, j, k)) / (g.dx * g.dx);
  const Real z = (q(i, j, k + 1) - 2 * q(i, j, k) + q(i, j, k - 1)) / (g.dz * g.dz);
  const Real above = (q(i, j + 1, k) - q(i, j, k)) / g.dy_face[j + 1];
  const Real below = (q(i, j, k) - q(i, j - 1, k)) / g.dy_face[j];
  return x + z + (above - below) / g.dy[j];
}

double volume_mean(const grid::Field& q, const Domain& d) {
  const auto& g = d.grid;
  const double here =
      grid::sum_cells(grid::all_cells(g), [&](int i, int j, int k) { return q(i, j, k) * g.dy[j]; });
  return parallel::sum(d.decomposition.all(), here) / (double(g.nx_global) * g.nz_global * g.height);
}

void remove_mean(grid::Field& q, const Domain& d) {
  const double mean = volume_mean(q, d);
  grid::for_each_cell(grid::all_cells(d.grid), [&](int i, int j, int k) { q(i, j, k) -= mean; });
}

/// What may be left of the operator applied to the solution: a few ulps of its largest terms.
double round_off_of(const grid::Field& psi, const Domain& d) {
  const auto& g = d.grid;
  double finest = g.dy[0];
  for (int j = 0; j < g.ny; ++j) finest = std::fmin(finest, g.dy[j]);
  const double largest = parallel::maximum(
      d.decomposition.all(),
      grid::max_cells(grid::all_cells(g), 0.0, [&](int i, int j, int k) { return std::abs(psi(i, j, k)); }));
  return support::round_off(64) * largest * 4 *
         (1 / (g.dx * g.dx) + 1 / (finest * finest) + 1 / (g.dz * g.dz));
}

void expect_exact_inverse(Domain::Size n, double stretching) {
  SCOPED_TRACE(testing::Message() << n.nx << " x " << n.ny << " x " << n.nz << ", stretching " << stretching);
  Domain d(MPI_COMM_WORLD, n, {}, support::faces(n.ny, 2.3, stretching));
  const auto& g = d.grid;
  grid::Field rhs(g, 1);
  support::set_by_index(rhs, g, g.ny, [](int i, int j, int k) { return support::noise(1, i, j, k); });
  remove_mean(rhs, d);
  const grid::Field psi = solve(d, rhs);
  const double bound = round_off_of(psi, d);
  EXPECT_LT(bound, support::round_off(4e6));  // the bar itself must mean something beside rhs = O(1)
  double worst = 0;
  for (int k = 0; k < g.nz; ++k) {
    for (int j = 0; j < g.ny; ++j) {
      for (int i = 0; i < g.nx; ++i)
        worst = support::worse(worst, std::abs(laplacian(psi, g, i, j, k) - rhs(i, j, k)));
    }
  }
  EXPECT_LT(worst, bound);
  EXPECT_NEAR(volume_mean(psi, d), 0, support::round_off(400));
}

TEST(Poisson, InvertsTheDiscreteLaplacianOnAnyGridAndRanks) {
  const std::vector<Domain::Size> sizes{{8, 6, 8},  {9, 7, 8},   {8, 5, 9},   {9, 8, 7},  {16, 12, 12},
                                        {12, 8, 6}, {13, 9, 11}, {18, 10, 9}, {7, 3, 20}, {20, 4, 7}};
  int solved = 0;
  for (const auto& n : sizes) {
    if (!support::fits(n.nx, n.nz, support::world_size())) continue;
    ++solved;
    for (const double stretching : {0.0, 1.8}) expect_exact_inverse(n, stretching);
  }
  EXPECT_GE(solved, 4);
}

/// Largest error against psi = cos(2 pi x / Lx) sin(4 pi z / Lz) cos(pi y / H).
double error_on(int n, double stretching) {
  constexpr double pi = std::numbers::pi, height = 2;
  const Domain::Lengths length{3, 1.5};
  Domain d(MPI_COMM_WORLD, {n, n, n}, length, support::faces(n, height, stretching));
  const double a = 2 * pi / length.x, b = pi / height, c = 4 * pi / length.z;
  const auto exact = [=](double x, double y, double z) {
    return std::cos(a * x) * std::cos(b * y) * std::sin(c * z);
  };
  grid::Field rhs(d.grid, 1);
  support::set_by_position(rhs, d.grid, support::kCenter, [=](double x, double y, double z) {
    return -(a * a + b * b + c * c) * exact(x, y, z);
  });
  return support::largest_error(solve(d, rhs), d.grid, support::kCenter, d.decomposition, exact);
}

TEST(Poisson, IsSecondOrderAgainstAnAnalyticSolution) {
  for (const double stretching : {0.0, 1.5}) {
    const std::vector<double> errors{error_on(24, stretching), error_on(48, stretching)};
    const std::vector<double> finer{errors[1], error_on(96, stretching)};
    EXPECT_NEAR(support::last_order(errors), 2, 0.15) << "stretching " << stretching;
    EXPECT_NEAR(support::last_order(finer), 2, 0.05) << "stretching " << stretching;
  }
}

TEST(Poisson, IgnoresAUniformSource) {
  // A net source has no solution with closed walls: the solver must return something finite.
  Domain d(MPI_COMM_WORLD, {12, 6, 9}, {}, support::faces(6));
  grid::Field rhs(d.grid, 1);
  support::set_by_index(rhs, d.grid, d.grid.ny, [](int, int, int) { return 1.0; });
  const grid::Field psi = solve(d, rhs);
  EXPECT_TRUE(
      std::isfinite(support::largest(support::global_values(psi, d.grid, d.grid.ny, d.decomposition.all()))));
}

}  // namespace
}  // namespace softwall::pressure
