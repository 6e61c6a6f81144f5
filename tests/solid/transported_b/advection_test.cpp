#include "solver/solid/transported_b/advection.hpp"

#include <gtest/gtest.h>

#include "solver/solid/material.hpp"
#include "tests/support/fields.hpp"

// Transport in flux form: what leaves one cell enters the next, and a solenoidal flow leaves constants alone.
namespace softwall::solid {
namespace {

using support::Domain;

struct Parameters {
  double stretching;
  WenoWeights weights;
};

class AdvectionOn : public testing::TestWithParam<Parameters> {
 protected:
  Domain d{MPI_COMM_WORLD, {14, 12, 13}, {}, support::faces(12, 2, GetParam().stretching)};
  Advection advection{d.grid, GetParam().weights};
  grid::Field q{d.grid, Material::kGhost}, rate{d.grid, 1};

  Velocity base(const grid::VectorField& v) const {
    return {v.x.view(), v.y.view(), v.z.view(), d.grid.upper_share.data()};
  }

  /// Values in all rows, those beyond the walls included; ghost columns from the neighbours.
  template <class Value>
  void fill(const Value& value) {
    const auto& g = d.grid;
    for (int k = 0; k < g.nz; ++k) {
      for (int j = -q.ghost(); j < g.ny + q.ghost(); ++j) {
        for (int i = 0; i < g.nx; ++i) q(i, j, k) = value(g.x_begin + i, j, g.z_begin + k);
      }
    }
    d.halo.fill({&q});
  }

  double sum_of_rates(int first_row, const grid::RowArray& height, double* size) const {
    const auto box = grid::rows(d.grid, first_row, d.grid.ny);
    const auto& comm = d.decomposition.all();
    *size = parallel::sum(
        comm, grid::sum_cells(box, [&](int i, int j, int k) { return std::abs(rate(i, j, k)) * height[j]; }));
    return parallel::sum(
        comm, grid::sum_cells(box, [&](int i, int j, int k) { return rate(i, j, k) * height[j]; }));
  }

  template <class PointVelocity>
  void expect_conserved(const grid::VectorField& velocity) {
    fill([](int i, int j, int k) { return support::noise(6, i, j, k); });
    advection.rate_of(q, PointVelocity{base(velocity)}, 0, rate);
    const bool y_face = PointVelocity::kOnYFace;
    double size = 0;
    const double sum = sum_of_rates(y_face ? 1 : 0, y_face ? d.grid.dy_face : d.grid.dy, &size);
    EXPECT_GT(size, 1);
    EXPECT_NEAR(sum, 0, 1e-14 * size);
  }

  template <class PointVelocity>
  void expect_constant_kept(const grid::VectorField& velocity) {
    fill([](int, int, int) { return 3.0; });
    advection.rate_of(q, PointVelocity{base(velocity)}, 0, rate);
    double worst = 0;
    for (int k = 0; k < d.grid.nz; ++k) {
      for (int j = PointVelocity::kOnYFace ? 1 : 0; j < d.grid.ny; ++j) {
        for (int i = 0; i < d.grid.nx; ++i) worst = support::worse(worst, std::abs(rate(i, j, k)));
      }
    }
    EXPECT_LT(worst, 1e-12);
  }
};

TEST_P(AdvectionOn, ConservesTheSumAtCentersAndEdgesBetweenTheWalls) {
  const auto velocity = support::random_solenoidal_velocity(d, 3);
  expect_conserved<CenterVelocity>(velocity);
  expect_conserved<EdgeXzVelocity>(velocity);
}

TEST_P(AdvectionOn, ConservesTheSumOnEdgesThatReachTheWalls) {
  // The control volumes around y faces end half a cell from the walls: nothing may flow through the first and
  // the last cell there for the sum over the inner rows to be constant.
  auto velocity = support::random_velocity(d, 3);
  for (int k = -1; k <= d.grid.nz; ++k) {
    for (int i = -1; i <= d.grid.nx; ++i) velocity.y(i, 1, k) = velocity.y(i, d.grid.ny - 1, k) = 0;
  }
  expect_conserved<EdgeXyVelocity>(velocity);
  expect_conserved<EdgeYzVelocity>(velocity);
}

TEST_P(AdvectionOn, KeepsConstants) {
  const auto velocity = support::random_solenoidal_velocity(d, 3);
  expect_constant_kept<CenterVelocity>(velocity);
  expect_constant_kept<EdgeXyVelocity>(velocity);
  expect_constant_kept<EdgeXzVelocity>(velocity);
  expect_constant_kept<EdgeYzVelocity>(velocity);
}

TEST_P(AdvectionOn, LetsNothingThroughTheLowFaceOfTheBand) {
  const auto velocity = support::random_solenoidal_velocity(d, 3);
  fill([](int i, int j, int k) { return support::noise(6, i, j, k); });
  const double untouched = 77;
  const int first_row = 5;
  grid::for_each_cell(grid::all_cells(d.grid), [&](int i, int j, int k) { rate(i, j, k) = untouched; });
  advection.rate_of(q, CenterVelocity{base(velocity)}, first_row, rate);
  double size = 0;
  EXPECT_NEAR(sum_of_rates(first_row, d.grid.dy, &size), 0, 1e-12);
  EXPECT_GT(size, 1);
  for (int j = 0; j < first_row; ++j) EXPECT_EQ(rate(0, j, 0), untouched);
}

TEST_P(AdvectionOn, CarriesALinearProfileAlongEveryDirection) {
  // q = a x + b y + c z seen by a uniform flow: rate = -(U a + V b + W c), away from the seams of x and z.
  // In y only on a uniform grid: WENO counts cells, not heights.
  const auto& g = d.grid;
  const bool uniform = GetParam().stretching == 0;
  const double U = 1.5, V = uniform ? -0.7 : 0, W = 0.4, a = 0.3, b = 0.9, c = -1.1;
  grid::VectorField velocity(g, 1);
  for (int k = -1; k <= g.nz; ++k) {
    for (int j = -1; j <= g.ny; ++j) {
      for (int i = -1; i <= g.nx; ++i) {
        velocity.x(i, j, k) = U;
        velocity.y(i, j, k) = V;
        velocity.z(i, j, k) = W;
      }
    }
  }
  fill([&](int i, int j, int k) {
    return a * i * g.dx + b * (uniform ? j * g.dy[0] : g.y_center[j]) + c * k * g.dz;
  });
  const auto expect_rate = [&] {
    for (int k = 0; k < g.nz; ++k) {
      for (int i = 0; i < g.nx; ++i) {
        const int x = g.x_begin + i, z = g.z_begin + k;
        if (x < 3 || x > g.nx_global - 4 || z < 3 || z > g.nz_global - 4) continue;
        for (int j = 4; j < g.ny - 4; ++j) ASSERT_NEAR(rate(i, j, k), -(U * a + V * b + W * c), 1e-11);
      }
    }
  };
  advection.rate_of(q, CenterVelocity{base(velocity)}, 0, rate);
  expect_rate();
  advection.rate_of(q, EdgeXyVelocity{base(velocity)}, 0, rate);
  expect_rate();
  advection.rate_of(q, EdgeXzVelocity{base(velocity)}, 0, rate);
  expect_rate();
  advection.rate_of(q, EdgeYzVelocity{base(velocity)}, 0, rate);
  expect_rate();
}

INSTANTIATE_TEST_SUITE_P(GridsAndWeights, AdvectionOn,
                         testing::Values(Parameters{0, WenoWeights::kJiangShu},
                                         Parameters{0, WenoWeights::kZ},
                                         Parameters{1.8, WenoWeights::kJiangShu},
                                         Parameters{1.8, WenoWeights::kZ}));

}  // namespace
}  // namespace softwall::solid
