#include "solver/parallel/line_shift.hpp"

#include <gtest/gtest.h>

namespace softwall::parallel {
namespace {

double label(int rank, int round, std::size_t n) { return rank + 100.0 * round + 1e-4 * double(n); }

/// Rounds follow each other at once, so that a buffer written too early would show.
TEST(LineShift, HandsOnWhatEachRankHasAgainAndAgain) {
  const auto line = Communicator::duplicate(MPI_COMM_WORLD);
  const int ranks = line.size(), rank = line.rank();
  for (const Way way : {Way::kBest, Way::kMessages}) {
    LineShift<double> shift(line, way);
    int round = 0;
    for (const std::size_t count : {1000, 3, 3000, 2999}) {  // grows once it is in use
      for (const int direction : {1, 1, -1, 1, -1, -1}) {
        double* const outgoing = shift.outgoing(count);
        for (std::size_t n = 0; n < count; ++n) outgoing[n] = label(rank, round, n);
        const double* const incoming = shift.shift(direction);
        const int from = (rank - direction + ranks) % ranks;
        std::size_t wrong = 0;  // asserted only when counted: who stops would leave the others waiting
        for (std::size_t n = 0; n < count; ++n) wrong += incoming[n] == label(from, round, n) ? 0 : 1;
        EXPECT_EQ(wrong, 0U) << "round " << round;
        ++round;
      }
    }
  }
}

TEST(LineShift, MayHandOnNothing) {
  const auto line = Communicator::duplicate(MPI_COMM_WORLD);
  LineShift<double> shift(line);
  (void)shift.outgoing(0);
  (void)shift.shift(1);
}

}  // namespace
}  // namespace softwall::parallel
