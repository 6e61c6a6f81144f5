#include "solver/run_directory/build_info.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <regex>
#include <thread>

namespace softwall {
namespace {

TEST(UtcNow, OrdersWhatFollowsWithinASecond) {
  const std::regex iso_8601(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)");
  std::string before = utc_now();
  for (int i = 0; i < 20; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const std::string after = utc_now();
    EXPECT_TRUE(std::regex_match(after, iso_8601)) << after;
    EXPECT_LT(before, after);
    before = after;
  }
}

TEST(UtcText, IsADateBefore1970Too) {
  using std::chrono::milliseconds;
  EXPECT_EQ(utc_text(milliseconds(0)), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(utc_text(milliseconds(-886)), "1969-12-31T23:59:59.114Z");
  EXPECT_EQ(utc_text(milliseconds(-86400000)), "1969-12-31T00:00:00.000Z");
  EXPECT_EQ(utc_text(milliseconds(4294967296123)), "2106-02-07T06:28:16.123Z");
}

}  // namespace
}  // namespace softwall
