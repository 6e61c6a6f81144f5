#include "solver/case/bad_input.hpp"

#include <gtest/gtest.h>

namespace softwall {
namespace {

TEST(BadInput, HasALineForEachMistake) {
  const BadInput error("some.json", {{"/a", "-1", "must be positive"}, {"", "cannot be opened", ""}});
  EXPECT_STREQ(error.what(), "some.json:\n  /a: -1; must be positive\n  cannot be opened");
}

TEST(BadInput, CutsAnEndlessList) {
  const BadInput error("some.json", std::vector<Mistake>(1000, {"/a", "bad", "good"}));
  EXPECT_EQ(error.mistakes.size(), 1000U);
  EXPECT_LT(std::string(error.what()).size(), 2000U);
  EXPECT_NE(std::string(error.what()).find("and 950 more"), std::string::npos);
}

TEST(Printable, LetsNothingThroughThatATerminalObeys) {
  EXPECT_EQ(printable_excerpt("plain text"), "plain text");
  EXPECT_EQ(printable_excerpt("\033[31m\n\x07"), "\\u001b[31m\\n\\u0007");
  EXPECT_EQ(printable_excerpt("\xff\xc3\xa4"), "\\ufffd\\u00e4");
  EXPECT_EQ(printable_excerpt("\xe2\x80\xae"), "\\u202e");  // turns the reading direction round
  EXPECT_EQ(printable_excerpt(std::string(500, 'x'), 10), "xxxxxxxxxx...");
}

}  // namespace
}  // namespace softwall
