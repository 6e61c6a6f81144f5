#include "solver/parallel/reduce.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace softwall::parallel {
namespace {

/// Numbers whose sum depends on the order of addition.
double part(int rank) { return rank % 3 == 0 ? 1e16 : (rank % 3 == 1 ? 1.0 / 3.0 : -1e16); }

TEST(Reduce, SumsInRankOrder) {
  const auto comm = Communicator::duplicate(MPI_COMM_WORLD);
  double expected = 0;
  for (int rank = 0; rank < comm.size(); ++rank) expected += part(rank);
  for (int repeat = 0; repeat < 20; ++repeat) EXPECT_EQ(sum(comm, part(comm.rank())), expected);
}

TEST(Reduce, SumsElementByElement) {
  const auto comm = Communicator::duplicate(MPI_COMM_WORLD);
  const double r = comm.rank(), n = comm.size();
  std::array<double, 3> values{1.0, r, r * r};
  sum(comm, values);
  EXPECT_DOUBLE_EQ(values[0], n);
  EXPECT_DOUBLE_EQ(values[1], n * (n - 1) / 2);
  EXPECT_DOUBLE_EQ(values[2], (n - 1) * n * (2 * n - 1) / 6);
}

TEST(Reduce, SumsMoreThanItHasRoomForAtOnce) {
  const auto comm = Communicator::duplicate(MPI_COMM_WORLD);
  const double r = comm.rank(), n = comm.size();
  std::vector<double> values((std::size_t{1} << 20) + 3);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = r + static_cast<double>(i);
  sum(comm, values);
  for (std::size_t i = 0; i < values.size(); ++i)
    ASSERT_EQ(values[i], n * static_cast<double>(i) + n * (n - 1) / 2) << i;
}

TEST(Reduce, FindsExtremesOfNegativeNumbersToo) {
  const auto comm = Communicator::duplicate(MPI_COMM_WORLD);
  EXPECT_EQ(maximum(comm, -1.0 - comm.rank()), -1.0);
  EXPECT_EQ(minimum(comm, -1.0 - comm.rank()), -double(comm.size()));
}

TEST(Reduce, OneRankIsEnoughForAny) {
  const auto comm = Communicator::duplicate(MPI_COMM_WORLD);
  EXPECT_FALSE(any(comm, false));
  EXPECT_TRUE(any(comm, comm.rank() == comm.size() - 1));
}

}  // namespace
}  // namespace softwall::parallel
