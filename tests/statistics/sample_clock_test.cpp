#include "solver/statistics/sample_clock.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace softwall::statistics {
namespace {

TEST(SampleClock, CountsStepsFromTheirStartTimeOn) {
  SampleClock clock;
  EXPECT_EQ(clock.counted(1, 0.5, 1), 0);
  EXPECT_EQ(clock.counted(1.5, 1, 1), 0.5);
  EXPECT_EQ(clock.counted(2, 0.5, 1), 0.5);
}

TEST(SampleClock, LetsSamplesStandForAllTimeThatCounts) {
  SampleClock clock;
  clock.counted(1.25, 0.5, 1);
  clock.counted(1.75, 0.5, 1);
  EXPECT_EQ(clock.take(1.75), 0.75);
  clock.counted(2, 0.25, 1);
  EXPECT_EQ(clock.take(2), 0.25);
  EXPECT_EQ(clock.last_sample(), 2);
}

TEST(SampleClock, ContinuesFromWhatWasPacked) {
  SampleClock clock, resumed, fresh;
  clock.counted(1.5, 0.5, 1);
  resumed.unpack(clock.pack());
  resumed.counted(2, 0.5, 1);  // does not start it again
  EXPECT_EQ(resumed.take(2), 1);
  fresh.unpack(SampleClock().pack());
  fresh.counted(1.5, 0.5, 1);
  EXPECT_EQ(fresh.take(1.5), 0.5);
  EXPECT_THROW(fresh.unpack({}), std::runtime_error);
}

}  // namespace
}  // namespace softwall::statistics
