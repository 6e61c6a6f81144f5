#include "solver/time/closed_box/closed_box.hpp"

#include <gtest/gtest.h>

#include "tests/support/flows.hpp"

namespace softwall::time {
namespace {

Physics implicit_cavity_with_disc(int nx, int ny) {
  Physics p = support::cavity_with_disc(nx, ny);
  p.time_step.viscosity = ViscousTerms::kImplicit;
  return p;
}

double area(const State& s, const Setup& setup) {
  double sum = 0;
  for (const double phi :
       support::global_values(s.material.phi, setup.grid, setup.grid.ny, setup.decomposition.all()))
    sum += phi;
  return sum;
}

TEST(ClosedBox, GoesOnWithTheSameBitsAfterARestart) {
  for (const Physics& p : {support::cavity_with_disc(24, 26), implicit_cavity_with_disc(24, 26)}) {
    time::Setup setup(p, MPI_COMM_WORLD);
    State s = closed_box_at_start(setup);
    for (int n = 0; n < 12; ++n) {
      support::step(s, setup);
      time::Setup second(p, MPI_COMM_WORLD);
      State copy = support::reread(s, second);
      start(copy, second);
      ASSERT_EQ(support::all_fields(copy, second), support::all_fields(s, setup))
          << "start() at step " << s.step;
      support::step(copy, second);
      support::step(s, setup);
      ASSERT_EQ(support::all_fields(copy, second), support::all_fields(s, setup)) << "after step " << s.step;
    }
  }
}

TEST(ClosedBox, IsTheSameOnAnyNumberOfRanks) {
  const Physics p = implicit_cavity_with_disc(24, 26);
  const auto after = [&](MPI_Comm comm) {
    time::Setup setup(p, comm);
    State s = closed_box_at_start(setup);
    for (int n = 0; n < 20; ++n) advance(s, setup, 0.01);
    return support::all_fields(s, setup);
  };
  const auto together = after(MPI_COMM_WORLD), alone = after(MPI_COMM_SELF);
  for (std::size_t f = 0; f < alone.size(); ++f) {
    EXPECT_LT(support::largest_difference(together[f], alone[f]), 1e-11 * (1 + support::largest(alone[f])))
        << "field " << f;
  }
}

TEST(ClosedBox, KeepsItsSolidAndHasNoDivergence) {
  time::Setup setup(implicit_cavity_with_disc(32, 32), MPI_COMM_WORLD);
  State s = closed_box_at_start(setup);
  const double before = area(s, setup);
  while (s.time < 1) support::step(s, setup);
  EXPECT_NEAR(area(s, setup), before, 1e-12 * before);
  EXPECT_LT(pressure::max_divergence(s.velocity, setup.grid, setup.decomposition), 1e-11);
  EXPECT_EQ(s.driving_gradient, 0);
  const auto u = support::global_values(s.velocity.x, setup.grid, setup.grid.ny, setup.decomposition.all());
  EXPECT_GT(support::largest(u), 0.5) << "the lid should have set the fluid in motion";
}

TEST(ClosedBox, DoesNotFeelAnUndeformedDiscAtRest) {
  time::Setup setup(support::cavity_with_disc(24, 24), MPI_COMM_WORLD);
  setup.walls.top_u = 0;
  State s = closed_box_at_start(setup);
  for (int n = 0; n < 10; ++n) support::step(s, setup);
  EXPECT_LT(support::largest(support::all_velocity(s, setup)), 1e-14);
}

TEST(ClosedBox, ARotationCarriesTheDiscOnceAround) {
  Physics p = support::cavity_with_disc(32, 32);
  p.flow = FlowType::kRotation;
  p.solid->disc = DiscSpec{.x = 0.5, .y = 0.7, .radius = 0.15};
  time::Setup setup(p, MPI_COMM_WORLD);
  State s = closed_box_at_start(setup);
  const auto velocity = support::all_velocity(s, setup);
  const auto at = [&] {
    return support::global_values(s.material.phi, setup.grid, setup.grid.ny, setup.decomposition.all());
  };
  const auto begin = at();
  const double before = area(s, setup);
  for (int n = 0; n < 128; ++n) advance(s, setup, 1.0 / 256);
  EXPECT_GT(support::largest_difference(at(), begin), 0.9) << "half way it is on the other side";
  for (int n = 0; n < 128; ++n) advance(s, setup, 1.0 / 256);
  double wrong = 0;
  const auto end = at();
  for (std::size_t n = 0; n < end.size(); ++n) wrong += (end[n] > 0.5) != (begin[n] > 0.5) ? 1 : 0;
  EXPECT_LT(wrong, 0.1 * before);
  EXPECT_NEAR(area(s, setup), before, 1e-12 * before);
  EXPECT_EQ(support::all_velocity(s, setup), velocity) << "it is prescribed";
  EXPECT_LT(support::largest_difference(support::all_fields(s, setup)[5], std::vector<double>(end.size(), 1)),
            1e-9)
      << "a rotation does not stretch";
}

TEST(ClosedBox, ImplicitViscosityDoesNotLimitTheStep) {
  time::Setup explicitly(support::cavity(64, 64), MPI_COMM_WORLD);
  Physics p = support::cavity(64, 64);
  p.time_step.viscosity = ViscousTerms::kImplicit;
  time::Setup implicitly(p, MPI_COMM_WORLD);
  State a = closed_box_at_start(explicitly), b = closed_box_at_start(implicitly);
  EXPECT_STREQ(choose_time_step(a, explicitly).limit, "viscosity");
  EXPECT_STREQ(choose_time_step(b, implicitly).limit, "convection");
  EXPECT_NEAR(choose_time_step(b, implicitly).dt, 0.8 * std::sqrt(3) / 64, 1e-12)
      << "of the lid: all is at rest";
}

}  // namespace
}  // namespace softwall::time
