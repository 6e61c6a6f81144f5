#include <gtest/gtest.h>

#include <cerrno>
#include <system_error>

#include "solver/output/agree.hpp"

namespace softwall::output {
namespace {

class AgreeTest : public testing::Test {
 protected:
  parallel::Communicator world_ = parallel::Communicator::duplicate(MPI_COMM_WORLD);
};

TEST_F(AgreeTest, WhatOneRankMeetsAllRanksThrow) {
  const int last = world_.size() - 1;
  try {
    agree(world_, ExitCode::kBadCase, [&] {
      if (world_.rank() == last) throw std::runtime_error("rank " + std::to_string(last) + " is unhappy");
    });
    ADD_FAILURE() << "nothing thrown";
  } catch (const AgreedError& error) {
    EXPECT_EQ(error.code, ExitCode::kBadCase);
    EXPECT_EQ(error.what(), "rank " + std::to_string(last) + " is unhappy");
  }
}

TEST_F(AgreeTest, TheCodeOfTheErrorTravelsWithIt) {
  try {
    agree_on_root(world_, ExitCode::kFailed,
                  [] { throw std::system_error(ENOSPC, std::generic_category(), "cannot write"); });
    ADD_FAILURE() << "nothing thrown";
  } catch (const AgreedError& error) {
    EXPECT_EQ(error.code, ExitCode::kIoFailure);
  }
}

TEST_F(AgreeTest, SilenceWhenAllIsWell) {
  EXPECT_NO_THROW(agree(world_, ExitCode::kFailed, [] {}));
  EXPECT_EQ(from_root(world_, world_.rank() == 0 ? "text of rank 0" : "other"), "text of rank 0");
  EXPECT_EQ(from_root(world_, ""), "");
}

}  // namespace
}  // namespace softwall::output
