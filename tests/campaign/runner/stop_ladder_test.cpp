#include "campaign/runner/stop_ladder.hpp"

#include <gtest/gtest.h>

namespace softwall::campaign {
namespace {

constexpr StopGrace kGrace = {100.0, 15.0};

TEST(StopLadder, BecomesFirmerByItself) {
  StopLadder ladder(kGrace, 0.0);
  EXPECT_EQ(ladder.due(0.0), StopLevel::kCheckpoint);
  EXPECT_EQ(ladder.due(5.0), std::nullopt);
  EXPECT_EQ(ladder.due(10.0), StopLevel::kCheckpoint) << "a request may be lost, so it is repeated";
  EXPECT_EQ(ladder.due(100.0), StopLevel::kTerminate);
  EXPECT_EQ(ladder.due(115.0), StopLevel::kKill);
}

TEST(StopLadder, APersonMakesItFirmerAtOnceAndNeverSofter) {
  StopLadder ladder(kGrace, 0.0);
  EXPECT_EQ(ladder.due(0.0), StopLevel::kCheckpoint);
  EXPECT_EQ(ladder.due(1.0, level_of_requests(2)), StopLevel::kTerminate);
  EXPECT_EQ(ladder.due(2.0, level_of_requests(3)), StopLevel::kKill);
  EXPECT_EQ(ladder.due(120.0, level_of_requests(1)), StopLevel::kKill);
}

}  // namespace
}  // namespace softwall::campaign
