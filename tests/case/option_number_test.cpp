#include "solver/case/option_number.hpp"

#include <gtest/gtest.h>

#include <string>

namespace softwall {
namespace {

TEST(OptionNumber, IsOfItsRange) {
  const OptionRange seconds{.low = 0, .low_allowed = true, .high = 1e9};
  for (const char* good : {"0", "0.5", "1e9", "1e-320"})
    EXPECT_EQ(trouble_with_number(good, seconds), "") << good;
  const OptionRange minutes{.low = 0, .low_allowed = false, .high = 1e6};
  EXPECT_EQ(trouble_with_number("0.001", minutes), "");
  EXPECT_EQ(trouble_with_number("0", minutes), "0 is not a number greater than 0 and of at most 1000000");
}

TEST(OptionNumber, IsNoNumberThatNobodyMeans) {
  const OptionRange range{.low = 0, .low_allowed = true, .high = 1e9};
  for (const char* bad :
       {"nan", "-nan", "inf", "infinity", "-1", "1e19", "1e400", "", " 1", "1 ", "1s", "0x10"}) {
    const std::string trouble = trouble_with_number(bad, range);
    EXPECT_NE(trouble, "") << bad;
    EXPECT_LT(trouble.size(), 80u) << trouble;
  }
}

}  // namespace
}  // namespace softwall
