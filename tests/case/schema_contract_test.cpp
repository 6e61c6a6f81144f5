#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "schemas/embedded.hpp"
#include "solver/case/case_schema.hpp"
#include "tests/case/examples.hpp"

/// schemas/case.schema.json and struct Case describe the same thing: a parameter forgotten on one side fails
/// here.
namespace softwall {
namespace {

using nlohmann::json;
using Pointer = json::json_pointer;

void collect_schema_leaves(const json& node, const std::string& at, std::set<std::string>& leaves) {
  if (!node.contains("properties"))
    leaves.insert(at);
  else
    for (const auto& [key, child] : node.at("properties").items())
      collect_schema_leaves(child, at + "/" + key, leaves);
}

std::set<std::string> schema_leaves() {
  std::set<std::string> leaves;
  collect_schema_leaves(*case_schema().part(Pointer()), "", leaves);
  return leaves;
}

std::set<std::string> leaves_of(const json& document) {
  std::set<std::string> leaves;
  const json flat = document.flatten();
  for (const auto& [name, unused] : flat.items()) {
    Pointer pointer(name);
    while (document.at(pointer.parent_pointer()).is_array()) pointer.pop_back();  // a list is one member
    leaves.insert(pointer.to_string());
  }
  return leaves;
}

/// Between them the examples hold every parameter: no flow has them all.
std::vector<json> examples() {
  return {tests::full_document(), tests::box_document(), tests::wave_document()};
}

TEST(SchemaContract, EveryParameterIsWrittenAndNothingElse) {
  std::set<std::string> written;
  for (const json& example : examples()) written.merge(leaves_of(to_json(parse_case(example.dump()))));
  EXPECT_EQ(written, schema_leaves());
}

TEST(SchemaContract, TheExamplesChangeEveryDefault) {
  for (const auto& pointer : schema_leaves()) {
    const json* node = case_schema().part(Pointer(pointer));
    ASSERT_NE(node, nullptr) << pointer;
    bool given = false, changed = !node->contains("default");
    for (const json& example : examples()) {
      if (!example.contains(Pointer(pointer))) continue;
      given = true;
      changed = changed || example.at(Pointer(pointer)) != node->at("default");
    }
    EXPECT_TRUE(given && changed) << pointer;
  }
}

/// A number without a bound is one that the code can be made to wrap round, or to wait for for ever.
TEST(SchemaContract, EveryNumberHasALargestValue) {
  for (const auto& pointer : schema_leaves()) {
    const json& node = *case_schema().part(Pointer(pointer));
    if (!node.contains("type") || (node.at("type") != "number" && node.at("type") != "integer")) continue;
    EXPECT_TRUE(node.contains("maximum")) << pointer;
    EXPECT_TRUE(node.contains("minimum") || node.contains("exclusiveMinimum")) << pointer;
    if (node.at("type") != "integer" || !node.contains("maximum")) continue;
    // An int holds it; a seed is read as an unsigned number of 32 bits.
    EXPECT_LE(node.at("maximum").get<double>(),
              pointer == "/physics/initial/seed" ? 4294967295.0 : 2147483647.0)
        << pointer;
  }
}

/// Removing any one member of the physics changes the id; removing one of the rest does not.
TEST(SchemaContract, PhysicsIsIdentityMemberByMember) {
  for (const json& full : examples()) {
    const std::string id = tests::id_of(full);
    for (const auto& pointer : schema_leaves()) {
      const Pointer place(pointer);
      if (!full.contains(place)) continue;
      const json* node = case_schema().part(place);
      if (node->contains("default") && full.at(place) == node->at("default")) continue;
      json without = full;
      without.at(place.parent_pointer()).erase(place.back());
      if (!tests::complaint_about(without).empty()) {
        const bool needed =
            !node->contains("default") || pointer == "/physics/grid/ny_solid" ||
            pointer == "/physics/grid/stretching" || pointer == "/physics/domain/layer_height" ||
            pointer == "/physics/initial/precursor" || pointer == "/physics/solid/extension" ||
            pointer == "/physics/solid/formulation" || pointer == "/physics/solid/interface" ||
            pointer == "/physics/domain/length_x";
        EXPECT_TRUE(needed) << pointer << " is needed although it has a default";
        continue;
      }
      EXPECT_EQ(tests::id_of(without) != id, pointer.starts_with("/physics/")) << pointer;
    }
  }
}

void expect_judged_alone(const json& node, const std::string& at) {
  const std::set<std::string> known = {"$schema",
                                       "$id",
                                       "title",
                                       "description",
                                       "unit",
                                       "type",
                                       "enum",
                                       "const",
                                       "default",
                                       "minimum",
                                       "maximum",
                                       "items",
                                       "maxItems",
                                       "pattern",
                                       "properties",
                                       "required",
                                       "maxLength",
                                       "minLength",
                                       "identity_default",
                                       "exclusiveMinimum",
                                       "additionalProperties"};
  for (const auto& [word, unused] : node.items()) EXPECT_TRUE(known.contains(word)) << at << ": " << word;
  const json required = node.value("required", json::array());
  const json members = node.value("properties", json::object());
  for (const auto& name : required)
    EXPECT_FALSE(members.at(name.get<std::string>()).contains("default")) << at << "/" << name;
  for (const auto& [name, child] : members.items()) expect_judged_alone(child, at + "/" + name);
}

/// The campaign manager checks only the values in which a case differs from a sound one, and documents with
/// their defaults filled in. Both would be wrong if one member decided about another, or if a required member
/// had a default.
TEST(SchemaContract, EveryMemberIsJudgedAlone) { expect_judged_alone(*case_schema().part(Pointer()), ""); }

TEST(SchemaContract, EveryParameterIsDescribedOrSpeaksForItself) {
  for (const auto& pointer : schema_leaves()) {
    const json& node = *case_schema().part(Pointer(pointer));
    const bool typed = node.contains("type") || node.contains("enum") || node.contains("const");
    EXPECT_TRUE(typed) << pointer;
    if (node.value("type", "") == "number") {
      EXPECT_TRUE(node.contains("description")) << pointer << " has no unit";
    }
  }
}

TEST(SchemaContract, DefaultsAreAllowedByTheirOwnBounds) {
  for (json document : examples()) {
    for (const auto& pointer : schema_leaves())
      if (const json* node = case_schema().part(Pointer(pointer));
          node->contains("default") && document.contains(Pointer(pointer).parent_pointer()))
        document[Pointer(pointer)] = node->at("default");
    EXPECT_TRUE(case_schema().mistakes(document).empty());
  }
}

TEST(SchemaContract, StatusAndSummaryAcceptWhatASolverWrites) {
  const JsonSchema status(schemas::kStatusSchema), summary(schemas::kSummarySchema);
  json live =
      json::parse(R"({"format": 1, "case_id": "0123456789abcdef", "attempt": 1, "pid": 12, "host": "node",
      "ranks": 2, "step": 10, "time": 0.5, "end_time": 3, "dt": 0.01, "dt_limit": "elastic",
      "seconds_per_step": 0.1, "checkpoint_step": 0, "updated": 1700000000})");
  json end = json::parse(R"({"format": 1, "case_id": "0123456789abcdef", "attempt": 1, "outcome": "finished",
      "reason": "end time reached", "exit_code": 0, "step": 10, "time": 3.01, "end_time": 3, "attempt_steps": 10,
      "wall_seconds": 1.5, "ns_per_cell_step": 100, "checkpoint": "checkpoints/checkpoint-000000010.h5",
      "resumed_from": "", "diagnostics": {"divergence": 1e-13, "undefined": null},
      "provenance": {"version": "0.1.0", "git_revision": "abc", "build_type": "Release", "compiler": "GNU 12",
                     "host": "node", "ranks": 2, "started": "2024-01-01T00:00:00Z", "ended": "2024-01-01T00:00:02Z"}})");
  EXPECT_TRUE(status.mistakes(live).empty());
  EXPECT_TRUE(summary.mistakes(end).empty());
  live["case_id"] = "not an id";
  end["outcome"] = "splendid";
  EXPECT_EQ(status.mistakes(live).size(), 1U);
  EXPECT_EQ(summary.mistakes(end).size(), 1U);
}

}  // namespace
}  // namespace softwall
