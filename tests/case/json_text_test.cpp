#include "solver/case/json_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/case/examples.hpp"

namespace softwall {
namespace {

using nlohmann::json;

std::string complaint_about_text(const std::string& text) {
  return tests::complaint([&] { return parse_json(text, "text"); });
}

TEST(JsonText, ReadsWhatIsJson) {
  EXPECT_EQ(parse_json(" {\"a\": [1, 2.5, \"x\", true, null, {}]} \n", "text"),
            json::parse(R"({"a": [1, 2.5, "x", true, null, {}]})"));
  EXPECT_EQ(parse_json("3", "text"), 3);
  EXPECT_EQ(parse_json(R"(["\u00e4\ud83d\ude00"])", "text"), json::parse(R"(["ä😀"])"));
}

TEST(JsonText, OneRepresentationPerNumber) {
  for (const char* text : {"1", "1.0", "1e0", "0.1e1", "10E-1", "1.000"}) {
    EXPECT_TRUE(parse_json(text, "text").is_number_integer()) << text;
    EXPECT_EQ(parse_json(text, "text").dump(), "1") << text;
  }
  for (const char* text : {"0", "-0", "-0.0", "0e5", "1e-400"})
    EXPECT_EQ(parse_json(text, "text").dump(), "0") << text;
  EXPECT_EQ(parse_json("9007199254740992", "text").dump(), "9007199254740992");
  EXPECT_TRUE(parse_json("18446744073709551616", "text").is_number_float());
  EXPECT_THROW(static_cast<void>(normalised_number(std::nan(""))), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(normalised_number(std::numeric_limits<double>::infinity())),
               std::invalid_argument);
}

TEST(JsonText, SaysWhere) {
  EXPECT_NE(complaint_about_text("{\"a\": 1,\n \"b\": nul}").find("line 2, column 10"), std::string::npos)
      << complaint_about_text("{\"a\": 1,\n \"b\": nul}");
  EXPECT_NE(complaint_about_text("{\"a\":\n\n  1e999}").find("line 3, column 7"), std::string::npos)
      << complaint_about_text("{\"a\":\n\n  1e999}");
  EXPECT_NE(complaint_about_text("{\"a\": [{\"b\": 1, \"b\": 2}]}").find("/a/0/b: key given twice"),
            std::string::npos);
}

TEST(JsonText, RefusesEverythingElse) {
  const std::vector<std::string> bad{"",
                                     "   ",
                                     "\xEF\xBB\xBF{}",
                                     std::string("\xFF\xFE{\0}\0", 6),
                                     std::string("{}\0", 3),
                                     std::string("{}\0{}", 5),
                                     "{\"a\": 1,}",
                                     "[1,]",
                                     "[1 2]",
                                     "{\"a\" 1}",
                                     "{\"a: 1}",
                                     "{'a': 1}",
                                     "{a: 1}",
                                     "// no\n{}",
                                     "/* no */ {}",
                                     "# no\n{}",
                                     "{",
                                     "{}}",
                                     "{} {}",
                                     "{} x",
                                     "[\"a\nb\"]",
                                     "[\"a\tb\"]",
                                     "[\"\\x\"]",
                                     "[\"\\u12G4\"]",
                                     "[\"\\ud800\"]",
                                     "[\"\xC0\xAF\"]",
                                     "[\"\xFF\"]",
                                     "[\"\xE2\x82\"]",
                                     "[\"\xF4\x90\x80\x80\"]",
                                     "[01]",
                                     "[+1]",
                                     "[.5]",
                                     "[1.]",
                                     "[1e]",
                                     "[0x10]",
                                     "[NaN]",
                                     "[Infinity]",
                                     "[-Infinity]",
                                     "[True]",
                                     "[None]",
                                     "[undefined]",
                                     "[1e999]",
                                     "[-1e999]",
                                     "{\"a\": 1, \"a\": 1}"};
  for (const auto& text : bad) {
    const std::string message = complaint_about_text(text);
    EXPECT_FALSE(message.empty()) << "accepted: " << text;
    EXPECT_EQ(message.find("json.exception"), std::string::npos) << message;
    EXPECT_LT(message.size(), 400U) << message;
  }
}

TEST(JsonText, LimitsDepthAndSize) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(complaint_about_text(nested(kJsonDepthLimit)), "");
  EXPECT_NE(complaint_about_text(nested(kJsonDepthLimit + 1)).find("nested deeper"), std::string::npos);
  EXPECT_NE(complaint_about_text(std::string(1000000, '[')).find("nested deeper"), std::string::npos);
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_NE(complaint_about_text(objects).find("nested deeper"), std::string::npos);
  std::string many = "[0";
  for (std::size_t i = 0; i < kJsonValueLimit; ++i) many += ",0";
  EXPECT_NE(complaint_about_text(many + "]").find("values"), std::string::npos);
  EXPECT_NE(complaint_about_text("[\"" + std::string(1000000, 'x') + "\n\"]").find("line 1"),
            std::string::npos);
  EXPECT_LT(complaint_about_text("[\"" + std::string(1000000, 'x') + "\n\"]").size(), 1000U);
  EXPECT_NE(complaint_about_text("[1" + std::string(1000000, '0') + "]").find("overflow"), std::string::npos);
}

}  // namespace
}  // namespace softwall
