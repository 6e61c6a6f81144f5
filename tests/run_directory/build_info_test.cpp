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

}  // namespace
}  // namespace softwall
