#include "solver/parallel/shared_memory.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

// The ranks of a test are on one machine: each finds in the memory of every other what that one wrote there.
namespace softwall::parallel {
namespace {

void barrier(const Communicator& line) { check(MPI_Barrier(line.get()), "MPI_Barrier"); }

/// Some numbers of one rank, more on later ones.
std::vector<int> numbers_of(int rank) {
  std::vector<int> numbers;
  for (int n = 0; n < 1000 * (rank + 1); ++n) numbers.push_back(10 * n + rank);
  return numbers;
}

std::vector<int> read(const Mapping& memory, int rank) {
  std::vector<int> numbers(numbers_of(rank).size());
  std::memcpy(numbers.data(), memory.data(), numbers.size() * sizeof(int));
  return numbers;
}

TEST(SharedMemory, IsTheSameForAllRanks) {
  const auto line = Communicator::duplicate(MPI_COMM_WORLD);
  const auto mine = numbers_of(line.rank());
  const auto all = share_memory(line, mine.size() * sizeof(int));
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), static_cast<std::size_t>(line.size()));
  std::memcpy((*all)[static_cast<std::size_t>(line.rank())].data(), mine.data(), mine.size() * sizeof(int));
  barrier(line);
  for (int r = 0; r < line.size(); ++r)
    EXPECT_EQ(read((*all)[static_cast<std::size_t>(r)], r), numbers_of(r));
}

TEST(SharedMemory, MayBeEmpty) {
  const auto line = Communicator::duplicate(MPI_COMM_WORLD);
  EXPECT_TRUE(share_memory(line, 0));
}

TEST(SharedMemory, IsRefusedOnEveryRankWhenOneHasNotEnough) {
  const auto line = Communicator::duplicate(MPI_COMM_WORLD);
  constexpr std::size_t kMoreThanAnyFile = std::size_t(1) << 63;
  const bool last = line.rank() == line.size() - 1;
  EXPECT_FALSE(share_memory(line, last ? kMoreThanAnyFile : 100));
}

}  // namespace
}  // namespace softwall::parallel
