#include "campaign/core/expression.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace softwall::campaign {
namespace {

const std::map<std::string, double> kValues = {
    {"G", 0.5}, {"ny_fluid", 128}, {"grid.nx", 16}, {"zero", 0}, {"huge", 1e308}};

double value(const std::string& text) {
  return Expression(text).value([](const std::string& name) { return kValues.at(name); });
}

std::string complaint(const std::string& text) {
  try {
    value(text);
  } catch (const ExpressionError& error) {
    return error.what();
  }
  return "";
}

TEST(Expression, HasTheUsualPrecedence) {
  EXPECT_EQ(value("1 + 2 * 3"), 7);
  EXPECT_EQ(value("(1 + 2) * 3"), 9);
  EXPECT_EQ(value("10 - 4 - 3"), 3);
  EXPECT_EQ(value("16 / 4 / 2"), 2);
  EXPECT_EQ(value("1 - 2 * 3 + 8 / 4"), -3);
  EXPECT_EQ(value("2 * (3 + 4) * 5"), 70);
}

TEST(Expression, HasSigns) {
  EXPECT_EQ(value("-2"), -2);
  EXPECT_EQ(value("--2"), 2);
  EXPECT_EQ(value("3 - -2"), 5);
  EXPECT_EQ(value("3 * -2"), -6);
  EXPECT_EQ(value("+2"), 2);
  EXPECT_EQ(value("-(1 + 2)"), -3);
}

TEST(Expression, KnowsNumbersAsTheyAreWritten) {
  EXPECT_EQ(value("2800"), 2800);
  EXPECT_EQ(value(".5"), 0.5);
  EXPECT_EQ(value("1e3"), 1000);
  EXPECT_EQ(value("1.5E-1"), 0.15);
  EXPECT_EQ(value("1e3+1"), 1001);
}

TEST(Expression, AsksForTheValuesOfNames) {
  EXPECT_EQ(value("2800 * G"), 1400);
  EXPECT_EQ(value(" ny_fluid/4 "), 32);
  EXPECT_EQ(value("grid.nx * 2"), 32);
  EXPECT_EQ(Expression("G * ny_fluid + G").names(), (std::vector<std::string>{"G", "ny_fluid"}));
}

TEST(Expression, HasFunctions) {
  EXPECT_EQ(value("min(3, 1, 2)"), 1);
  EXPECT_EQ(value("max(3, ny_fluid / 4)"), 32);
  EXPECT_EQ(value("max(7)"), 7);
  EXPECT_EQ(value("round(2.5) + round(-2.5)"), 0);
  EXPECT_EQ(value("round(ny_fluid / 3)"), 43);
}

TEST(Expression, SaysWhereItCannotBeRead) {
  EXPECT_EQ(complaint(""), "expected a number, a parameter or \"(\" after the last character");
  EXPECT_EQ(complaint("1 +"), "expected a number, a parameter or \"(\" after the last character");
  EXPECT_EQ(complaint("1 + * 2"), "expected a number, a parameter or \"(\" at character 5, \"* 2\"");
  EXPECT_EQ(complaint("2 G"), "expected + - * / or the end at character 3, \"G\"");
  EXPECT_EQ(complaint("(1 + 2"), "expected \")\" after the last character");
  EXPECT_EQ(complaint("1 + 2)"), "expected + - * / or the end at character 6, \")\"");
  EXPECT_EQ(complaint("2 ^ 3"), "expected + - * / or the end at character 3, \"^ 3\"");
  EXPECT_EQ(complaint("0x10"), "expected + - * / or the end at character 2, \"x10\"");
  EXPECT_EQ(complaint("1e999"), "expected a number that can be held at character 1, \"1e999\"");
  EXPECT_EQ(complaint("rond(G)"), "no such function: rond; did you mean round? at character 1, \"rond(G)\"");
  EXPECT_EQ(complaint("round(1, 2)"), "expected \")\" at character 8, \", 2)\"");
}

TEST(Expression, LeavesNoFiniteNumberUntold) {
  EXPECT_EQ(complaint("1 / zero"), "divides by zero");
  EXPECT_EQ(complaint("1 / (G - 0.5)"), "divides by zero");
  EXPECT_EQ(complaint("huge * 10"), "is not a finite number");
  EXPECT_EQ(complaint("1 / (huge * 10)"), "is not a finite number") << "although the result would be 0";
}

TEST(Expression, BearsAnyDepth) {
  EXPECT_EQ(value(std::string(64, '(') + "1" + std::string(64, ')')), 1);
  EXPECT_NE(complaint(std::string(100000, '(')).find("parentheses too deep"), std::string::npos);
  EXPECT_EQ(value(std::string(100000, '-') + "1"), 1);
}

}  // namespace
}  // namespace softwall::campaign
