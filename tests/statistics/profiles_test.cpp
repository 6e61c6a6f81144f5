#include "solver/statistics/profiles.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "solver/parallel/reduce.hpp"
#include "solver/run_directory/quantities.hpp"
#include "solver/solid/elastic_force.hpp"
#include "solver/solid/excess_viscosity.hpp"
#include "tests/statistics/flows.hpp"
#include "tests/support/momentum_at_a_point.hpp"

namespace softwall::statistics {
namespace {

using namespace testing;

/// Plane mean of row j of any function of the cell.
template <class Value>
double row_mean(const time::Setup& setup, int j, const Value& value) {
  double sum = 0;
  for_columns(setup.grid, j, j + 1, [&](int i, int, int k, double, double) { sum += value(i, j, k); });
  return parallel::sum(setup.decomposition.all(), sum) / (setup.grid.nx_global * setup.grid.nz_global);
}

TEST(Profiles, OfTrigonometricFieldsOnAStretchedGridAreExact) {
  time::Setup setup(rigid_case(), MPI_COMM_WORLD);
  const auto& g = setup.grid;
  auto s = time::state_at_rest(g, std::nullopt);
  // v = b f(y) cos at the faces; u carries the same wave shifted so that <u v> is known at the edges.
  const double alpha = 2 * kPi / g.length_x, beta = 2 * kPi / g.length_z;
  const auto f = [](double y) { return y * (2 - y); };
  for_columns(g, 0, g.ny, [&](int i, int j, int k, double x, double z) {
    const double y = g.y_center[j], xc = x + g.dx / 2, zc = z + g.dz / 2;
    s.velocity.x(i, j, k) = 3 * y + 0.5 * std::cos(alpha * x);
    s.velocity.y(i, j, k) = 0.2 * f(g.y_face[j]) * std::cos(alpha * xc) + 0.1 * f(g.y_face[j]);
    s.velocity.z(i, j, k) = -1 + 0.7 * std::sin(beta * z);
    s.pressure(i, j, k) = y * y + 0.4 * std::cos(beta * zc);
  });
  time::start(s, setup);
  const auto means = plane_means(s, setup);
  const double spread = std::cos(alpha * g.dx / 2);  // v averaged in x to the edge
  for (int j = 0; j < g.ny; ++j) {
    const double y = g.y_center[j], fl = f(g.y_face[j]), fh = f(g.y_face[j + 1]);
    EXPECT_NEAR(means(kU, j), 3 * y, 1e-13);
    EXPECT_NEAR(means(kUu, j), 9 * y * y + 0.125, 1e-12);
    EXPECT_NEAR(means(kV, j), 0.1 * (fl + fh) / 2, 1e-13);
    EXPECT_NEAR(means(kVv, j), 0.03 * (fl * fl + fh * fh) / 2, 1e-13);
    EXPECT_NEAR(means(kVvFace, j), 0.03 * fl * fl, 1e-13);
    EXPECT_NEAR(means(kW, j), -1, 1e-13);
    EXPECT_NEAR(means(kWw, j), 1 + 0.245, 1e-13);
    EXPECT_NEAR(means(kP, j), y * y, 1e-13);
    EXPECT_NEAR(means(kPp, j), y * y * y * y + 0.08, 1e-12);
    if (j == 0) continue;
    const double u_face = 3 * (y + g.y_center[j - 1]) / 2;
    EXPECT_NEAR(means(kUv, j), 0.1 * fl * u_face + 0.5 * 0.5 * 0.2 * fl * spread, 1e-13);
    EXPECT_NEAR(means(kViscousStress, j), 3 * setup.viscosity, 1e-14);
  }
  EXPECT_NEAR(means(kViscousStress, 0), 3 * setup.viscosity, 1e-14);  // u = 3 y at the wall too
  const double y_top = g.y_center[g.ny - 1];
  EXPECT_NEAR(means(kViscousStress, g.ny), -3 * y_top / (2 - y_top) * setup.viscosity, 1e-13);
  EXPECT_EQ(means(kUv, 0), 0);
  EXPECT_EQ(means(kUv, g.ny), 0);
}

TEST(Profiles, StressesAreTheFluxesOfTheMomentumEquation) {
  for (const auto& physics : {rigid_case(), elastic_case()}) {
    time::Setup setup(physics, MPI_COMM_WORLD);
    const auto s = rough_state(setup);
    const auto& g = setup.grid;
    const auto m = fluid::momentum_input(s.velocity, g, setup.viscosity);
    const solid::InterfaceShare by_volume(solid::kMeanByVolume, g);
    solid::ExcessViscosity excess(s.elastic ? physics.solid->viscosity_ratio : 1, 0.9, by_volume, g);
    solid::ElasticForce elastic({s.elastic ? grid::Real(physics.solid->G) : 0}, by_volume, g);
    if (s.elastic) {
      for (int k = 0; k < g.nz; ++k) elastic.find(s.material, 0, k);
      excess.renew(s.material, s.velocity, 0);
    }
    const auto means = plane_means(s, setup);
    const auto total = [&](int j) {
      return means(kViscousStress, j) - means(kUv, j) + (s.elastic ? means(kElasticStress, j) : 0.0);
    };
    for (int j = 0; j < g.ny; ++j) {
      const double rate = row_mean(setup, j, [&](int i, int row, int k) {
        return fluid::momentum_x(m, i, row, k) + elastic.now().x(i, row, k) +
               setup.viscosity * excess.force().x(i, row, k);
      });
      EXPECT_NEAR((total(j + 1) - total(j)) * g.inv_dy[j], rate, 1e-11) << j;
    }
    EXPECT_GT(std::abs(means(kUv, 5)), 1e-3);
  }
}

TEST(Profiles, OfTheSolidAreMeansOfItsFields) {
  time::Setup setup(elastic_case(), MPI_COMM_WORLD);
  const auto s = rough_state(setup);
  const auto& g = setup.grid;
  const auto& m = s.material;
  const auto means = plane_means(s, setup);
  for (int j = 0; j < g.ny; ++j) {
    const auto mean = [&](const auto& value) { return row_mean(setup, j, value); };
    EXPECT_NEAR(means(kPhi, j), mean([&](int i, int r, int k) { return m.phi(i, r, k); }), 1e-14);
    EXPECT_NEAR(means(kElasticXx, j),
                mean([&](int i, int r, int k) { return 2 * m.phi(i, r, k) * m.B.xx(i, r, k); }), 1e-13);
    EXPECT_NEAR(means(kElasticYy, j),
                mean([&](int i, int r, int k) { return 2 * m.phi(i, r, k) * m.B.yy(i, r, k); }), 1e-13);
    EXPECT_NEAR(means(kElasticZz, j),
                mean([&](int i, int r, int k) { return 2 * m.phi(i, r, k) * m.B.zz(i, r, k); }), 1e-13);
    const double flow = mean([&](int i, int r, int k) {
      return (1 - (m.phi(i, r, k) + m.phi(i - 1, r, k)) / 2) * s.velocity.x(i, r, k);
    });
    EXPECT_NEAR(means(kFluidU, j), flow, 1e-13);
  }
  EXPECT_GT(means(kElasticXx, g.ny - 1), 0.5);
}

TEST(Profiles, DoNotDependOnTheNumberOfRanks) {
  for (const auto& physics : {rigid_case(), elastic_case()}) {
    time::Setup together(physics, MPI_COMM_WORLD), alone(physics, MPI_COMM_SELF);
    const auto here = plane_means(rough_state(together), together);
    const auto there = plane_means(rough_state(alone), alone);
    ASSERT_EQ(here.values().size(), there.values().size());
    for (std::size_t n = 0; n < here.values().size(); ++n) {
      EXPECT_NEAR(here.values()[n], there.values()[n], 1e-13) << n;
    }
  }
}

TEST(Profiles, EveryOneHasANameAndAMeaning) {
  std::set<std::string> names;
  for (const auto& kind : profile_kinds(true)) {
    EXPECT_TRUE(names.insert(std::string(kind.name)).second) << kind.name;
    const bool known = analysis::known_meaning(std::string(kind.name)) != nullptr;
    EXPECT_NE(known, !kind.description.empty()) << kind.name << ": exactly one place explains it";
  }
}

}  // namespace
}  // namespace softwall::statistics
