#include <gtest/gtest.h>

#include "solver/statistics/profiles.hpp"
#include "solver/time/advance.hpp"
#include "solver/time/initial.hpp"
#include "tests/support/convergence.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/solids.hpp"

// Laminar Poiseuille flow under an elastic layer at rest, sheared by the flow and by the driving gradient:
//   0 < y < 2: u = 3/2 y (2 - y), P = 3 / Re;  2 < y: u = 0, B_xy = P (1 - y) / G, B_xx = 1 + B_xy^2.
namespace softwall::time {
namespace {

constexpr double kReynolds = 5;
constexpr double kGradient = 3 / kReynolds;

double parabola(double y) { return y < 2 ? 1.5 * y * (2 - y) : 0; }

struct Errors {
  double velocity = 0;  ///< largest, over the maximum 3/2
  double shear = 0;     ///< largest of B_xy inside the solid, over its value at the interface
  double stretch = 0;   ///< largest of B_xx - 1, over its value at the wall
  double stress = 0;    ///< of the viscous and elastic stress together at the interface, over P
  double balance = 0;   ///< largest of the total stress about the straight line with the measured P, over P
};

Errors errors_of(const State& s, const time::Setup& setup) {
  const auto& g = setup.grid;
  const double G = setup.physics.solid->G;
  Errors e;
  e.velocity = support::largest_error(s.velocity.x, g, support::kFaceX, setup.decomposition,
                                      [](double, double y, double) { return parabola(y); }) /
               1.5;
  const auto shear = [&](double y) { return kGradient * (1 - y) / G; };
  for (int j = g.ny_fluid + 1; j < g.ny; ++j) {
    e.shear = support::worse(e.shear, std::abs(s.material.B.xy(0, j, 0) - shear(g.y_face[j])));
    const double stretch = std::pow(shear(g.y_center[j]), 2);
    e.stretch = support::worse(e.stretch, std::abs(s.material.B.xx(0, j, 0) - 1 - stretch));
  }
  e.shear /= std::abs(shear(2));
  e.stretch /= std::pow(shear(g.height), 2);
  const auto means = statistics::plane_means(s, setup);
  const auto stress = [&](int j) {
    return means(statistics::kViscousStress, j) + means(statistics::kElasticStress, j);
  };
  e.stress = std::abs(stress(g.ny_fluid) + kGradient) / kGradient;
  for (int j = 0; j <= g.ny; ++j) {
    const double line = stress(0) - s.driving_gradient * g.y_face[j];
    e.balance = support::worse(e.balance, std::abs(stress(j) - line) / kGradient);
  }
  return e;
}

struct Layer {
  double G, viscosity_ratio, stretching;
};

/// From the exact state to where the scheme wants to stay.
Errors settle(const SolidSpec& solid, const Layer& layer, int ny_fluid) {
  Physics p = support::elastic_channel({1, ny_fluid, ny_fluid / 4, 1});
  p.reynolds = kReynolds;
  p.grid.stretching = layer.stretching;
  if (layer.stretching > 0) p.grid.ny_solid = ny_fluid / 2;
  p.layer_height = 0.5;
  p.solid = support::made_of(solid, layer.G, layer.viscosity_ratio);
  time::Setup setup(p, MPI_COMM_WORLD);
  const auto& g = setup.grid;
  State s = state_at_rest(setup);
  support::set_by_position(s.velocity.x, g, support::kFaceX,
                           [](double, double y, double) { return parabola(y); });
  const auto integral = [](double y) { return y - y * y / 2; };
  const auto displacement = [&](double y) {
    return kGradient / layer.G * (integral(y) - integral(g.height));
  };
  support::shear_material(s.material, g, g.ny_fluid, displacement,
                          [&](double y) { return kGradient * (1 - y) / layer.G; });
  start(s, setup);
  while (s.time < (layer.viscosity_ratio < 1 ? 6 : 2) * kReynolds)
    advance(s, setup, choose_time_step(s, setup).dt);
  return errors_of(s, setup);
}

class PoiseuilleUnderALayer : public testing::TestWithParam<support::NamedSolid> {
 protected:
  /// On grids of `coarse` cells in the fluid, twice and four times as many; returns the finest's errors.
  Errors expect_order(const std::string& name, const Layer& layer, double order, int coarse = 8) {
    std::vector<double> velocity, shear, stretch, stress;
    Errors e;
    for (const int ny_fluid : {coarse, 2 * coarse, 4 * coarse}) {
      e = settle(GetParam().spec, layer, ny_fluid);
      velocity.push_back(e.velocity);
      shear.push_back(e.shear);
      stretch.push_back(e.stretch);
      stress.push_back(e.stress);
      EXPECT_LT(e.balance, 1e-4) << "not yet at rest";
    }
    const std::string title = "Poiseuille under a layer, " + name;
    support::expect_order(title + ", u", velocity, order);
    support::expect_order(title + ", B_xy", shear, order);
    support::expect_order(title + ", B_xx", stretch, order);
    support::expect_order(title + ", stress at the interface", stress, order);
    return e;
  }
  static void expect_small(const Errors& e) {
    for (const double error : {e.velocity, e.shear, e.stretch, e.stress}) EXPECT_LT(error, 5e-3);
  }
};

TEST_P(PoiseuilleUnderALayer, OfTheSameViscosityIsSecondOrder) {
  expect_small(expect_order("equal viscosities", {1, 1, 0}, 1.9));
}
TEST_P(PoiseuilleUnderALayer, OnAStretchedGridToo) {
  expect_small(expect_order("equal viscosities, stretched", {1, 1, 1.2}, 1.9, 12));
}

TEST_P(PoiseuilleUnderALayer, OfATenthOfTheViscosityToo) {
  expect_small(expect_order("viscosity ratio 0.1", {1, 0.1, 0}, 1.9));
}
TEST_P(PoiseuilleUnderALayer, OfTenTimesTheViscosityToo) {
  expect_small(expect_order("viscosity ratio 10", {1, 10, 0}, 1.9));
}

INSTANTIATE_TEST_SUITE_P(Solids, PoiseuilleUnderALayer, testing::ValuesIn(support::solids()),
                         support::solid_name);

}  // namespace
}  // namespace softwall::time
