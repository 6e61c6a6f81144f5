#include "campaign/system/clock.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace softwall::campaign {
namespace {

TEST(Duration, IsShort) {
  EXPECT_EQ(describe_duration(0), "0 s");
  EXPECT_EQ(describe_duration(59.6), "1 min");
  EXPECT_EQ(describe_duration(3.4 * 3600), "3 h 24 min");
  EXPECT_EQ(describe_duration(50 * 3600), "2 d 2 h");
}

TEST(Duration, OfAnyNumberIsSaid) {
  EXPECT_EQ(describe_duration(1e20), "more than 1000 years");
  EXPECT_EQ(describe_duration(1e300), "more than 1000 years");
  EXPECT_EQ(describe_duration(std::numeric_limits<double>::infinity()), "unknown");
  EXPECT_EQ(describe_duration(-1), "unknown");
}

TEST(Duration, OfAnEstimateIsNotSaidTwice) {
  EXPECT_EQ(describe_about(600), "about 10 min");
  EXPECT_EQ(describe_about(1e20), "more than 1000 years");
  EXPECT_EQ(describe_about(-1), "an unknown time");
}

}  // namespace
}  // namespace softwall::campaign
