#include <gtest/gtest.h>

#include "solver/time/initial.hpp"
#include "tests/support/flows.hpp"
#include "tests/support/solids.hpp"

// However many ranks share the box, they compute what one rank computes, up to round-off.
namespace softwall::time {
namespace {

using AllFields = std::vector<std::vector<double>>;

template <class Begin>
AllFields after_steps(const Physics& p, MPI_Comm comm, const Begin& begin) {
  time::Setup setup(p, comm);
  State s = begin(setup);
  for (int step = 0; step < 20; ++step) advance(s, setup, 0.01);
  return support::all_fields(s, setup);
}

template <class Begin>
void expect_independent_of_ranks(const Physics& p, const Begin& begin) {
  const AllFields together = after_steps(p, MPI_COMM_WORLD, begin),
                  alone = after_steps(p, MPI_COMM_SELF, begin);
  ASSERT_EQ(together.size(), alone.size());
  for (std::size_t f = 0; f < alone.size(); ++f) {
    EXPECT_LT(support::largest_difference(together[f], alone[f]), 1e-12 * (1 + support::largest(alone[f])))
        << "field " << f;
  }
}

void expect_both_formulations_independent_of_ranks(const Physics& p) {
  for (const auto formulation : support::kBothFormulations)
    expect_independent_of_ranks(support::formulated(p, formulation), support::smooth_state);
}

TEST(Ranks, RigidChannelIsTheSame) {
  Physics p = support::rigid_channel({13, 12, 0, 14});
  p.grid.stretching = 1.3;
  expect_independent_of_ranks(p, support::smooth_state);
  expect_independent_of_ranks(p, perturbed_laminar);
}

TEST(Ranks, ElasticChannelIsTheSame) {
  Physics p = support::elastic_channel({13, 12, 6, 14});
  p.reynolds = 500;
  p.solid->viscosity_ratio = 3;
  expect_both_formulations_independent_of_ranks(p);
}

TEST(Ranks, ElasticChannelWithAMooneyRivlinWallIsTheSame) {
  Physics p = support::elastic_channel({13, 12, 6, 14});
  p.reynolds = 500;
  p.solid->mooney_share = 0.5;
  expect_both_formulations_independent_of_ranks(p);
}

TEST(Ranks, ElasticChannelWithASharpInterfaceIsTheSame) {
  Physics p = support::elastic_channel({13, 12, 6, 14});
  p.reynolds = 500;
  for (const auto interface : {InterfaceTransport::kMthinc, InterfaceTransport::kHeight}) {
    p.solid->interface = interface;
    expect_independent_of_ranks(p, support::smooth_state);
  }
}

TEST(Ranks, PencilsInBothDirectionsAreTheSame) {
  // Six columns in z leave two parts there, so four and six ranks split x as well.
  if (support::world_size() == 3) GTEST_SKIP() << "three ranks do not fit";
  Physics p = support::elastic_channel({12, 12, 6, 6});
  p.reynolds = 500;
  for (const auto& solid : support::solids()) {
    p.solid = solid.spec;
    expect_independent_of_ranks(p, support::smooth_state);
  }
}

}  // namespace
}  // namespace softwall::time
