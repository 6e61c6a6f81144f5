#include <gtest/gtest.h>

#include "tests/support/flows.hpp"

// State is all that a checkpoint holds: a state put into a fresh Setup must go on as if nothing had happened,
// to the last bit, whenever that is done.
namespace softwall::time {
namespace {

/// Restarts after each of `steps` steps and compares the step after.
void expect_same_bits_from_any_moment(const Physics& p, int steps, bool limited) {
  time::Setup setup(p, MPI_COMM_WORLD);
  State s = support::smooth_state(setup);
  int bands = 0, last_band = 0;
  for (int n = 0; n < steps; ++n) {
    support::step(s, setup);
    time::Setup second(p, MPI_COMM_WORLD);
    State copy = support::reread(s, second);
    start(copy, second);
    ASSERT_EQ(support::all_fields(copy, second), support::all_fields(s, setup))
        << "start() changed the state of step " << s.step;
    support::step(copy, second);
    support::step(s, setup);
    const auto one = support::all_fields(s, setup), two = support::all_fields(copy, second);
    for (std::size_t f = 0; f < one.size(); ++f) {
      ASSERT_EQ(one[f], two[f]) << fields_of(s)[f].name << " after a restart at step " << s.step - 1;
    }
    if (setup.solid && std::exchange(last_band, setup.solid->first_row()) != setup.solid->first_row())
      ++bands;
  }
  if (!setup.solid) return;
  EXPECT_GE(bands, 3) << "the band of solid rows should have moved during the test";
  const auto touched = parallel::sum(setup.decomposition.all(), double(setup.solid->limited_cells()));
  if (limited) {
    EXPECT_GT(touched, 0) << "the limiter should have acted";
  }
}

TEST(Restart, RigidChannelGoesOnWithTheSameBits) {
  expect_same_bits_from_any_moment(support::rigid_channel({12, 12, 0, 8}), 3, false);
}

TEST(Restart, ElasticChannelGoesOnWithTheSameBits) {
  Physics p = support::elastic_channel({12, 16, 6, 8});
  p.reynolds = 300;
  p.solid->viscosity_ratio = 3;
  expect_same_bits_from_any_moment(p, 40, false);
}

TEST(Restart, ElasticChannelWithASharpInterfaceGoesOnWithTheSameBits) {
  Physics p = support::elastic_channel({12, 16, 6, 8});
  p.reynolds = 300;
  p.solid->interface = InterfaceTransport::kMthinc;
  expect_same_bits_from_any_moment(p, 40, false);
}

TEST(Restart, ElasticChannelUnderAHeightGoesOnWithTheSameBits) {
  Physics p = support::elastic_channel({12, 48, 18, 8});
  p.reynolds = 300;
  p.solid->G = 0.25;
  p.solid->viscosity_ratio = 3;
  p.solid->interface = InterfaceTransport::kHeight;
  expect_same_bits_from_any_moment(p, 40, false);
}

/// A soft and viscous wall, on rows as thin as its formulation needs for the band to move.
Physics soft_wall(SolidFormulation formulation) {
  const support::Cells cells = formulation == SolidFormulation::kReferenceMap ? support::Cells{12, 48, 18, 8}
                                                                              : support::Cells{12, 16, 6, 8};
  Physics p = support::formulated(support::elastic_channel(cells), formulation);
  p.reynolds = 300;
  p.solid->G = 0.25;
  p.solid->viscosity_ratio = 3;
  return p;
}

TEST(Restart, ElasticChannelWithAReferenceMapGoesOnWithTheSameBits) {
  for (const double stretching : {0.0, 1.0}) {
    Physics p = soft_wall(SolidFormulation::kReferenceMap);
    p.grid.stretching = stretching;
    expect_same_bits_from_any_moment(p, 40, false);
  }
}

TEST(Restart, AMooneyRivlinWallGoesOnWithTheSameBits) {
  for (const auto formulation : support::kBothFormulations) {
    Physics p = soft_wall(formulation);
    p.solid->mooney_share = 0.5;
    expect_same_bits_from_any_moment(p, 40, false);
  }
}

TEST(Restart, AnExplicitElasticForceGoesOnWithTheSameBits) {
  for (const auto formulation : support::kBothFormulations) {
    Physics p = soft_wall(formulation);
    p.solid->stiffness = Stiffness::kExplicit;
    expect_same_bits_from_any_moment(p, 120, false);
  }
}

TEST(Restart, AlsoWhenTheLimiterActs) {
  Physics p = support::elastic_channel({12, 16, 6, 8});
  p.reynolds = 300;
  p.solid->G = 0.25;
  p.solid->threshold = 0.3;
  p.solid->min_eigenvalue = 0.5;  // far above what is needed, so that many cells are touched
  p.grid.stretching = 1.0;
  expect_same_bits_from_any_moment(p, 40, true);
}

}  // namespace
}  // namespace softwall::time
