#include <gtest/gtest.h>

#include "solver/parallel/mpi.hpp"

/// Every rank runs every test; a failure on any of them fails the program.
int main(int argc, char** argv) {
  const softwall::parallel::Session session(&argc, &argv);
  testing::InitGoogleTest(&argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  auto& listeners = testing::UnitTest::GetInstance()->listeners();
  if (rank != 0) delete listeners.Release(listeners.default_result_printer());
  const int failed = RUN_ALL_TESTS();
  int failed_anywhere = 0;
  MPI_Allreduce(&failed, &failed_anywhere, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  if (failed != 0) std::fprintf(stderr, "rank %d has failures\n", rank);
  return failed_anywhere;
}
