#include "solver/solid/transported_b/normal_extension.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/fields.hpp"
#include "tests/support/order.hpp"
#include "tests/support/physics.hpp"

namespace softwall::solid {
namespace {

constexpr double kThreshold = 0.5, kRadius = 0.25;

/// A disc in the middle of a box, phi falling linearly over ten cells; B depends on the direction alone, so
/// that its continuation along the normal is known.
struct Around {
  static double phi_at(double x, double y, double h) {
    return std::clamp(0.5 + (kRadius - std::hypot(x - 0.5, y - 0.5)) / (10 * h), 0.0, 1.0);
  }
  static double b_at(double x, double y) {
    return 2 + (x - 0.5) / std::max(1e-9, std::hypot(x - 0.5, y - 0.5));
  }

  explicit Around(int n) : setup(support::cavity(n, n), MPI_COMM_WORLD), m(setup.grid) {
    const auto& g = setup.grid;
    support::set_by_position(m.phi, g, support::kCenter,
                             [&](double x, double y, double) { return phi_at(x, y, g.dx); });
    setup.halo.fill({&m.phi});
    const auto solid_only = [&](grid::Field& f, const support::Place& place) {
      support::set_by_position(f, g, place, [&](double x, double y, double) {
        return phi_at(x, y, g.dx) > 0.3 ? b_at(x, y) : -100.0;  // what the fluid would have made of it
      });
    };
    solid_only(m.B.xx, support::kCenter);
    solid_only(m.B.yy, support::kCenter);
    solid_only(m.B.zz, support::kCenter);
    solid_only(m.B.xy, support::kEdgeXy);
    solid_only(m.B.xz, support::kEdgeXz);
    solid_only(m.B.yz, support::kEdgeYz);
    fill();
  }

  void fill() { setup.halo.fill({&m.B.xx, &m.B.yy, &m.B.zz, &m.B.xy, &m.B.xz, &m.B.yz}); }

  void extend() {
    NormalExtension extension(setup.grid, setup.decomposition, setup.halo);
    extension.extend_shear(m, kThreshold);
    extension.extend_normal(m, kThreshold);
    fill();
  }

  [[nodiscard]] std::vector<double> all(const grid::Field& f, int rows) const {
    return support::global_values(f, setup.grid, rows, setup.decomposition.all());
  }

  time::Setup setup;
  Material m;
};

class AroundADisc : public testing::Test, public Around {
 protected:
  AroundADisc() : Around(40) {}
};

/// Mean error of two components in a ring of three cells around the disc, where phi has a gradient.
double error_in_the_ring(Around& disc) {
  const auto& g = disc.setup.grid;
  std::array<double, 2> error_and_count{};
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const double x = (g.x_begin + i + 0.5) * g.dx, y = g.y_center[j];
      const double cells_off = (std::hypot(x - 0.5, y - 0.5) - kRadius) / g.dx;
      if (cells_off < 0.5 || cells_off > 3) continue;
      error_and_count[0] += std::abs(disc.m.B.xx(i, j, 0) - Around::b_at(x, y)) +
                            std::abs(disc.m.B.xy(i, j, 0) - Around::b_at(x - g.dx / 2, y - g.dx / 2));
      error_and_count[1] += 2;
    }
  }
  parallel::sum(disc.setup.decomposition.all(), error_and_count);
  return error_and_count[0] / error_and_count[1];
}

TEST(NormalExtension, ContinuesBAlongTheNormalWithFirstOrder) {
  std::vector<double> errors;
  for (const int n : {32, 64, 128}) {
    Around disc(n);
    disc.extend();
    errors.push_back(error_in_the_ring(disc));
  }
  EXPECT_LT(errors[0], 0.1);
  EXPECT_NEAR(support::last_order(errors), 1, 0.3);
}

TEST_F(AroundADisc, LeavesTheSolidAloneAndMakesTheFarFluidIsotropic) {
  extend();
  const auto& g = setup.grid;
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const double x = (g.x_begin + i + 0.5) * g.dx, y = g.y_center[j];
      const double cells_off = (std::hypot(x - 0.5, y - 0.5) - kRadius) / g.dx;
      if (m.phi(i, j, 0) >= kThreshold) {
        EXPECT_EQ(m.B.xx(i, j, 0), b_at(x, y));
      }
      if (cells_off > NormalExtension::kLayers + 2) {
        EXPECT_EQ(m.B.xx(i, j, 0), 1);
        EXPECT_EQ(m.B.xy(i, j, 0), 0);
      }
    }
  }
}

TEST_F(AroundADisc, DoneAgainChangesNoBit) {
  extend();
  const auto& g = setup.grid;
  std::vector<std::vector<double>> once;
  for (const grid::Field* f : {&m.B.xx, &m.B.yy, &m.B.zz, &m.B.xy, &m.B.xz, &m.B.yz})
    once.push_back(all(*f, g.ny));
  extend();
  std::size_t n = 0;
  for (const grid::Field* f : {&m.B.xx, &m.B.yy, &m.B.zz, &m.B.xy, &m.B.xz, &m.B.yz}) {
    EXPECT_EQ(all(*f, g.ny), once[n++]);
  }
}

TEST_F(AroundADisc, DoesNotDependOnTheNumberOfRanks) {
  extend();
  const auto together = all(m.B.xx, setup.grid.ny);
  time::Setup one(support::cavity(40, 40), MPI_COMM_SELF);
  Material copy(one.grid);
  support::set_by_position(copy.phi, one.grid, support::kCenter,
                           [&](double x, double y, double) { return phi_at(x, y, one.grid.dx); });
  support::set_by_position(copy.B.xx, one.grid, support::kCenter, [&](double x, double y, double) {
    return phi_at(x, y, one.grid.dx) > 0.3 ? b_at(x, y) : -100.0;
  });
  one.halo.fill({&copy.phi, &copy.B.xx});
  NormalExtension(one.grid, one.decomposition, one.halo).extend_normal(copy, kThreshold);
  EXPECT_EQ(together, support::global_values(copy.B.xx, one.grid, one.grid.ny, one.decomposition.all()));
}

}  // namespace
}  // namespace softwall::solid
