#include "campaign/store/result_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "campaign/store/text_width.hpp"

namespace softwall::campaign::tests {
namespace {

std::string written(const ResultTable& table, TableFormat format) {
  std::ostringstream out;
  write_table(out, table, format);
  return out.str();
}

ResultTable one_row(const std::vector<Cell>& cells) {
  ResultTable table;
  for (std::size_t i = 0; i < cells.size(); ++i)
    table.columns.push_back(std::string(1, static_cast<char>('a' + i)));
  table.rows = {cells};
  return table;
}

TEST(CsvTable, ARowOfASingleNullIsNoBlankLine) {
  EXPECT_EQ(written(one_row({Cell(std::monostate{})}), TableFormat::kCsv), "a\n\"\"\n");
  EXPECT_EQ(written(one_row({Cell(std::monostate{}), Cell(std::monostate{})}), TableFormat::kCsv),
            "a,b\n,\n");
}

TEST(WholeNumber, IsAnIntegerWhereOneHoldsIt) {
  EXPECT_EQ(whole_number(5000), Cell(std::int64_t{5000}));
  EXPECT_EQ(whole_number(1e300), Cell(1e300));
  EXPECT_EQ(whole_number(-1e19), Cell(-1e19));
}

TEST(PrintableLines, KeepOnlyTheirLineBreaks) {
  EXPECT_EQ(printable_lines("one\n\033[31mtwo\n"), "one\n\\x1b[31mtwo\n");
}

TEST(VerticalTable, HasALineForEachValue) {
  const ResultTable table = {{"label", "re_tau"},
                             {{Cell("G=1"), Cell(179.5)}, {Cell("G=2\n"), Cell(std::monostate{})}}};
  EXPECT_EQ(written(table, TableFormat::kVertical),
            "label   G=1\nre_tau  179.5\n\nlabel   G=2\\n\nre_tau  -\n");
}

TEST(TextTable, AlignsNumbersRightAndTextLeft) {
  const ResultTable table = {{"label", "value"},
                             {{Cell("a"), Cell(1234.5678)},
                              {Cell("longer"), Cell(std::monostate{})},
                              {Cell("c"), Cell(std::int64_t{7})}}};
  EXPECT_EQ(written(table, TableFormat::kText),
            "label     value\n"
            "a       1234.57\n"
            "longer        -\n"
            "c             7\n");
}

TEST(TextTable, KeepsTheTerminalSafeAndCountsCharactersNotBytes) {
  const ResultTable table = {{"x", "y"}, {{Cell("\x1b[2J\n"), Cell("k")}, {Cell("Re_\u03c4"), Cell("k")}}};
  EXPECT_EQ(written(table, TableFormat::kText), "x          y\n\\x1b[2J\\n  k\nRe_\u03c4       k\n");
}

TEST(Printable, ShowsWhatWouldNotBeSeen) {
  EXPECT_EQ(printable("plain \u00e9 \U0001F30A"), "plain \u00e9 \U0001F30A");
  EXPECT_EQ(printable("a\tb\rc\x7f"), "a\\tb\\rc\\x7f");
  EXPECT_EQ(printable("\u202e"), "\\xe2\\x80\\xae");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a lone surrogate
  EXPECT_EQ(printable(std::string("\0", 1)), "\\x00");
}

TEST(Wrapped, BreaksAtBlanks) {
  EXPECT_EQ(wrapped("one two three four", 9, "  "), "one two\n  three\n  four");
  EXPECT_EQ(wrapped("unbreakable", 3), "unbreakable");
  EXPECT_EQ(wrapped("", 3), "");
}

TEST(Shortened, CutsBetweenCharacters) {
  EXPECT_EQ(shortened("\u03c4\u03c4\u03c4\u03c4", 4), "\u03c4\u03c4\u03c4\u03c4");
  EXPECT_EQ(shortened("\u03c4\u03c4\u03c4\u03c4\u03c4", 4), "\u03c4...");
}

TEST(Csv, QuotesByTheRules) {
  const ResultTable table = one_row({Cell("a,b"), Cell("say \"hi\""), Cell("two\nlines"), Cell(""),
                                     Cell(std::monostate{}), Cell(" padded"), Cell("plain")});
  EXPECT_EQ(written(table, TableFormat::kCsv),
            "a,b,c,d,e,f,g\n\"a,b\",\"say \"\"hi\"\"\",\"two\nlines\",\"\",,\" padded\",plain\n");
}

TEST(Csv, GivesAllDigits) {
  const double value = 0.1 + 0.2;
  const std::string text = written(one_row({Cell(value), Cell(std::int64_t{1} << 62)}), TableFormat::kCsv);
  EXPECT_EQ(text, "a,b\n0.30000000000000004,4611686018427387904\n");
  EXPECT_EQ(std::stod(text.substr(4)), value);
}

TEST(Json, GivesNumbersAsNumbersAndNullAsNull) {
  const ResultTable table =
      one_row({Cell(240.5), Cell(std::int64_t{1} << 62), Cell(std::monostate{}), Cell("x\"\n"),
               Cell(std::numeric_limits<double>::infinity()), Cell(1e-300), Cell(1e20)});
  const auto json = nlohmann::json::parse(written(table, TableFormat::kJson));
  ASSERT_EQ(json.size(), 1U);
  EXPECT_TRUE(json[0]["a"].is_number_float());
  EXPECT_EQ(json[0]["a"], 240.5);
  EXPECT_EQ(json[0]["b"], std::int64_t{1} << 62);
  EXPECT_TRUE(json[0]["c"].is_null());
  EXPECT_EQ(json[0]["d"], "x\"\n");
  EXPECT_TRUE(json[0]["e"].is_null());
  EXPECT_EQ(json[0]["f"], 1e-300);
  EXPECT_EQ(json[0]["g"], 1e20);
}

TEST(Json, IsValidForAnyTextAndForNoRows) {
  EXPECT_TRUE(nlohmann::json::accept(written(one_row({Cell("\xff\xfe")}), TableFormat::kJson)));
  EXPECT_EQ(nlohmann::json::parse(written({{"a"}, {}}, TableFormat::kJson)), nlohmann::json::array());
}

TEST(Json, LosesNoColumnOfTheSameName) {
  const ResultTable table = {{"a", "a"}, {{Cell(std::int64_t{1}), Cell(std::int64_t{2})}}};
  const auto json = nlohmann::json::parse(written(table, TableFormat::kJson));
  EXPECT_EQ(json[0]["a"], 1);
  EXPECT_EQ(json[0]["a_2"], 2);
}

}  // namespace
}  // namespace softwall::campaign::tests
