#include <gtest/gtest.h>

#include <tuple>

#include "tests/support/flows.hpp"
#include "tests/support/order.hpp"

// Order in time of the whole step, on a fixed grid, by Richardson: no exact solution needed.
namespace softwall::time {
namespace {

std::vector<double> velocity_at_end(const Physics& p, int steps, bool driven) {
  time::Setup setup(p, MPI_COMM_WORLD);
  if (!driven) setup.bulk_velocity.reset();
  State s = support::smooth_state(setup);
  for (int step = 0; step < steps; ++step) advance(s, setup, 0.5 / steps);
  return support::all_velocity(s, setup);
}

double order(const Physics& p, int steps, bool driven) {
  return support::richardson_order(velocity_at_end(p, steps, driven), velocity_at_end(p, 2 * steps, driven),
                                   velocity_at_end(p, 4 * steps, driven));
}

Physics channel(double reynolds, double stretching) {
  Physics p = support::rigid_channel({12, 10, 0, 8});
  p.reynolds = reynolds;
  p.grid.stretching = stretching;
  return p;
}

TEST(OrderInTime, AdvectionIsThird) {
  for (const double stretching : {0.0, 1.5}) EXPECT_NEAR(order(channel(1e6, stretching), 10, false), 3, 0.15);
}

TEST(OrderInTime, ViscosityIsThird) { EXPECT_NEAR(order(channel(4, 0), 40, false), 3, 0.15); }

TEST(OrderInTime, BothTogetherWithTheFlowRateHeldAreThird) {
  EXPECT_NEAR(order(channel(50, 1.2), 16, true), 3, 0.15);
}

class OrderInTimeOfASolid : public testing::TestWithParam<std::tuple<SolidFormulation, Stiffness>> {};

TEST_P(OrderInTimeOfASolid, ElasticCouplingIsSecondAtLeast) {
  // A solid box deforms smoothly. (The limiter is never called for, threshold and band have nothing to do.)
  Physics p = support::solid_box({12, 10, 0, 8});
  const auto [formulation, stiffness] = GetParam();
  p.solid->G = 2;
  p.solid->formulation = formulation;
  p.solid->stiffness = stiffness;
  const auto solid_at_end = [&](int steps) {
    time::Setup setup(p, MPI_COMM_WORLD);
    setup.bulk_velocity.reset();
    State s = state_at_rest(setup);
    s.material = support::solid_everywhere(setup.grid, p.solid->formulation);
    support::set_smooth_flow(s, setup);
    make_solenoidal(s, setup);
    for (int step = 0; step < steps; ++step) advance(s, setup, 0.25 / steps);
    EXPECT_EQ(setup.solid->limited_cells(), 0);
    return support::all_velocity(s, setup);
  };
  const double seen = support::richardson_order(solid_at_end(32), solid_at_end(64), solid_at_end(128));
  EXPECT_GT(seen, 1.9);
}

INSTANTIATE_TEST_SUITE_P(, OrderInTimeOfASolid,
                         testing::Combine(testing::ValuesIn(support::kBothFormulations),
                                          testing::Values(Stiffness::kExplicit, Stiffness::kImplicit)),
                         [](const auto& test) {
                           return std::string(support::name_of(std::get<0>(test.param))) +
                                  (std::get<1>(test.param) == Stiffness::kImplicit ? "Implicit" : "Explicit");
                         });

}  // namespace
}  // namespace softwall::time
