#include <gtest/gtest.h>

#include <random>
#include <set>

#include "solver/case/case_schema.hpp"
#include "tests/case/examples.hpp"

/// Damaged and hostile input, generated from valid documents. Whatever arrives, the reader gives a sound case
/// or one BadInput; any other exception, crash or sanitizer report fails the test.
namespace softwall {
namespace {

using nlohmann::json;
using Pointer = json::json_pointer;

enum class Verdict { kAccepted, kRefused };

Verdict read(const std::string& text) {
  try {
    const Case c = parse_case(text);
    const Case again = parse_case(to_json(c).dump());
    EXPECT_EQ(again.id, c.id) << text;
    EXPECT_EQ(to_json(again), to_json(c)) << text;
    return Verdict::kAccepted;
  } catch (const BadInput& error) {
    const std::string message = error.what();
    EXPECT_FALSE(error.mistakes.empty());
    EXPECT_LT(message.size(), 30000U);
    for (const char c : message)
      EXPECT_TRUE(c == '\n' || (c >= ' ' && c < 127)) << "byte " << int(c) << " in a message";
    return Verdict::kRefused;
  }
}

Verdict read(const json& document) { return read(document.dump()); }

TEST(Mutation, CutAnywhere) {
  const std::string text = tests::full_document().dump();
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_EQ(read(text.substr(0, length)), Verdict::kRefused) << length;
}

TEST(Mutation, OneByteDeletedDoubledOrFlipped) {
  const std::string text = tests::full_document().dump();
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string deleted = text, doubled = text;
    deleted.erase(at, 1);
    doubled.insert(at, 1, text[at]);
    static_cast<void>(read(deleted));
    static_cast<void>(read(doubled));
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = text;
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << bit));
      static_cast<void>(read(flipped));
    }
  }
}

TEST(Mutation, RandomDamage) {
  const std::string text = tests::elastic_document().dump();
  std::mt19937 random(20240501);
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = text;
    for (unsigned edits = 1 + random() % 5; edits > 0 && !damaged.empty(); --edits) {
      const std::size_t at = random() % damaged.size(), from = random() % text.size();
      if (random() % 2 == 0)
        damaged.replace(at, random() % 4, text.substr(from, random() % 12));
      else
        damaged[at] = static_cast<char>(random() % 256);
    }
    static_cast<void>(read(damaged));
  }
}

/// Every member, replaced by something of another kind: refused, and the message names the place.
TEST(Mutation, WrongTypesEverywhere) {
  const json full = tests::full_document();
  const std::vector<json> others{
      nullptr, true, json::array(), json::array({1}), json::object(), json::object({{"a", 1}}), "text", 1.5};
  std::size_t refused = 0;
  const json flat = full.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    for (const json& other : others) {
      const bool may_fit =
          (value.is_string() && other.is_string()) || (value.is_number() && other.is_number());
      if (may_fit) continue;
      json changed = full;
      changed[Pointer(pointer)] = other;
      const std::string message = tests::complaint_about(changed);
      EXPECT_NE(message.find("  " + pointer), std::string::npos)
          << pointer << " = " << other << " gave: " << message;
      ++refused;
    }
  }
  EXPECT_GT(refused, 150U);
}

/// Everything that the rate of a wave is checked against.
json filled_wave() {
  json document = tests::wave_document();
  case_schema().fill_defaults(document);
  return document;
}

TEST(Mutation, NumbersAtTheEdges) {
  const std::vector<const char*> edges{"0",
                                       "-1",
                                       "-0",
                                       "0.5",
                                       "1e308",
                                       "1e309",
                                       "1e-400",
                                       "9007199254740993",
                                       "9223372036854775808",
                                       "18446744073709551616",
                                       "-9223372036854775809",
                                       "1e-320",
                                       "4294967296",
                                       "2147483648"};
  for (const json& whole : {tests::full_document(), filled_wave()}) {
    const json flat = whole.flatten();
    for (const auto& [pointer, value] : flat.items()) {
      if (!value.is_number()) continue;
      for (const char* edge : edges) {
        json changed = whole;
        changed[Pointer(pointer)] = "@edge@";
        std::string text = changed.dump();
        text.replace(text.find("\"@edge@\""), 8, edge);
        static_cast<void>(read(text));
      }
    }
  }
}

TEST(Mutation, MembersRemovedOrAdded) {
  const json full = tests::full_document();
  std::set<Pointer> objects{Pointer()};
  const json flat = full.flatten();
  for (const auto& [text, unused] : flat.items()) {
    Pointer pointer(text);
    while (full.at(pointer.parent_pointer()).is_array()) pointer.pop_back();  // what is in a list has no key
    objects.insert(pointer.parent_pointer());
    json without = full;
    without.at(pointer.parent_pointer()).erase(pointer.back());
    static_cast<void>(read(without));
    json misspelt = full;
    misspelt.at(pointer.parent_pointer())[pointer.back() + "_"] = misspelt.at(pointer);
    const std::string message = tests::complaint_about(misspelt);
    EXPECT_NE(message.find("did you mean \"" + pointer.back() + "\"?"), std::string::npos) << message;
  }
  EXPECT_GE(objects.size(), 9U);
  for (const Pointer& object : objects)
    for (const std::string key : {"", "__proto__", "../x", "a/b~c", "\n\033[31m", "'; DROP TABLE cases;--",
                                  "\xF0\x9F\x98\x80", "0", "-"}) {
      json changed = full;
      changed[object][key] = 1;
      const std::string message = tests::complaint_about(changed);
      EXPECT_NE(message.find("unknown key"), std::string::npos) << object.to_string() << " " << key;
    }
}

TEST(Mutation, LabelsAreOnlyText) {
  for (const std::string label : {"", "../../etc", "/absolute", "$(touch /tmp/x)", "`id`", "a\nb", "\033[2J",
                                  "%s%n", "-rf", "a'); DROP"}) {
    json document = tests::rigid_document();
    document["label"] = label;
    EXPECT_EQ(parse_case(document.dump()).label, label);
    EXPECT_EQ(read(document), Verdict::kAccepted);
  }
  json document = tests::rigid_document();
  document["label"] = std::string(101, 'x');
  EXPECT_EQ(read(document), Verdict::kRefused);
  document["label"] = std::string(1000000, 'x');
  EXPECT_LT(tests::complaint_about(document).size(), 1000U);
}

}  // namespace
}  // namespace softwall
