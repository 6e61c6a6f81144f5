#include "solver/case/json_schema.hpp"

#include <gtest/gtest.h>

#include "solver/case/case_schema.hpp"
#include "tests/case/examples.hpp"

namespace softwall {
namespace {

using nlohmann::json;

const JsonSchema& schema() {
  static const JsonSchema example(R"({
    "type": "object", "additionalProperties": false, "required": ["name"],
    "properties": {
      "name": {"type": "string", "maxLength": 5},
      "size": {"type": "object", "default": {}, "additionalProperties": false, "properties": {
        "width": {"type": "number", "exclusiveMinimum": 0, "default": 1.5},
        "height": {"type": "integer", "minimum": 2, "maximum": 4}}},
      "list": {"type": "array", "items": {"enum": ["a", "b"]}},
      "copy": {"$ref": "#/properties/size/properties/height"},
      "other": {"$ref": "other.json#/x"}}})",
                                  {{"other.json", R"({"x": {"const": 7, "default": 7}})"}});
  return example;
}

/// All mistakes, one per line.
std::string found(const char* document) {
  std::string text;
  for (const auto& mistake : schema().mistakes(json::parse(document)))
    text += mistake.where + ": " + mistake.given + "; " + mistake.allowed + "\n";
  return text;
}

TEST(JsonSchema, AcceptsWhatIsRight) {
  EXPECT_EQ(found(R"({"name": "x"})"), "");
  EXPECT_EQ(found(R"({"name": "x", "size": {"height": 3}, "list": ["a"], "copy": 4, "other": 7})"), "");
}

TEST(JsonSchema, TellsAllMistakesAtOnce) {
  EXPECT_EQ(
      found(R"({"name": "too long", "size": {"width": 0, "height": 2.5, "heigth": 1}, "list": ["a", "c"],
                      "copy": 9, "other": 8})"),
      "/copy: 9; must be an integer from 2 to 4\n"
      "/list/1: \"c\"; must be one of \"a\", \"b\"\n"
      "/name: \"too long\"; must be text in quotes of at most 5 characters\n"
      "/other: 8; must be 7\n"
      "/size/heigth: unknown key; did you mean \"height\"?\n"
      "/size/height: 2.5; must be an integer from 2 to 4\n"
      "/size/width: 0; must be a number greater than 0\n");
}

TEST(JsonSchema, NamesMissingAndUnknownKeys) {
  EXPECT_EQ(found(R"({"zzz": 1})"),
            "/zzz: unknown key; known here: copy, list, name, other, size\n"
            "/name: missing; needs text in quotes of at most 5 characters\n");
  EXPECT_EQ(found("[]"), ": []; must be an object\n");
  EXPECT_EQ(found(R"({"name": "x", "size": []})"), "/size: []; must be an object\n");
}

TEST(JsonSchema, TellsWhereAMisplacedKeyBelongs) {
  EXPECT_EQ(found(R"({"name": "x", "width": 2})"), "/width: unknown key; belongs in /size\n");
  EXPECT_EQ(found(R"({"name": "x", "size": {"list": []}})"),
            "/size/list: unknown key; belongs at the top level\n");
}

TEST(JsonSchema, FillsDefaultsInsideDefaults) {
  json document = {{"name", "x"}};
  schema().fill_defaults(document);
  EXPECT_EQ(document, json::parse(R"({"name": "x", "other": 7, "size": {"width": 1.5}})"));
  json partly = {{"name", "x"}, {"size", {{"height", 3}}}};
  schema().fill_defaults(partly);
  EXPECT_EQ(partly.at("size"), json::parse(R"({"height": 3, "width": 1.5})"));
}

TEST(JsonSchema, DroppingDefaultsUndoesFilling) {
  for (const json& document : {tests::rigid_document(), tests::elastic_document(), tests::full_document()}) {
    json changed = document;
    case_schema().fill_defaults(changed);
    changed = case_schema().without_defaults(changed);
    json expected = document;  // a default that has changed stays, and the first one is dropped
    if (expected["physics"].contains("solid")) {
      json& solid = expected["physics"]["solid"];
      solid["formulation"] = "reference_map";
      solid["interface"] = "height";
      if (!solid.contains("stiffness")) {
        solid["stiffness"] = "implicit";
      } else if (solid.at("stiffness") == "explicit") {
        solid.erase("stiffness");
      }
    }
    EXPECT_EQ(changed, expected);
  }
}

TEST(JsonSchema, LeavesWrongTypesAlone) {
  json document = {{"size", 3}};
  schema().fill_defaults(document);
  document = schema().without_defaults(document);
  EXPECT_EQ(document, json::parse(R"({"size": 3})"));
}

TEST(JsonSchema, RefusesAReferenceToNowhere) {
  EXPECT_THROW(JsonSchema(R"({"$ref": "absent.json#/a"})"), std::logic_error);
}

}  // namespace
}  // namespace softwall
