#include "solver/case/case_id.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "solver/case/case_schema.hpp"
#include "tests/case/examples.hpp"

namespace softwall {
namespace {

using nlohmann::json;
using tests::id_of;

/// The same object as text, its members in random order.
std::string shuffled_text(const json& value, std::mt19937& random) {
  if (!value.is_object()) return value.dump();
  std::vector<std::string> members;
  for (const auto& [key, member] : value.items())
    members.push_back(json(key).dump() + " : " + shuffled_text(member, random));
  std::shuffle(members.begin(), members.end(), random);
  std::string text = "{ ";
  for (const auto& member : members) text += (text.size() > 2 ? ",\n " : "") + member;
  return text + "}";
}

TEST(CaseId, OrderOfKeysDoesNotMatter) {
  std::mt19937 random(1);
  const std::string id = id_of(tests::full_document());
  for (int i = 0; i < 50; ++i) EXPECT_EQ(parse_case(shuffled_text(tests::full_document(), random)).id, id);
}

TEST(CaseId, NumbersAreComparedAsNumbers) {
  const std::string text = tests::elastic_document().dump();
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return parse_case(changed).id;
  };
  const std::string id = parse_case(text).id;
  for (const char* spelling : {"\"nx\":32.0", "\"nx\":3.2e1", "\"nx\" : 320E-1"})
    EXPECT_EQ(with("\"nx\":32", spelling), id);
  for (const char* spelling : {"\"G\":0.50", "\"G\":5e-1", "\"G\":0.5000000000000000001"})
    EXPECT_EQ(with("\"G\":0.5", spelling), id);
  EXPECT_NE(with("\"G\":0.5", "\"G\":0.5000000000000001"), id);
}

TEST(CaseId, MinusZeroIsZero) {
  json document = tests::elastic_document();
  document["physics"]["statistics"]["start_time"] = -0.0;
  EXPECT_EQ(id_of(document), id_of(tests::elastic_document()));
  EXPECT_EQ(canonical_text(json(-0.0)), "0");
}

TEST(CaseId, DefaultsWrittenOrLeftOut) {
  for (const json& document : {tests::rigid_document(), tests::elastic_document(), tests::full_document()}) {
    json filled = document;
    case_schema().fill_defaults(filled);
    EXPECT_EQ(id_of(filled), id_of(document));
    EXPECT_EQ(case_id(filled.at("physics")), case_id(document.at("physics")));
  }
}

TEST(CaseId, ARigidChannelHasNoLayer) {
  json document = tests::rigid_document();
  document["physics"]["domain"]["layer_height"] = 0.75;
  EXPECT_EQ(id_of(document), id_of(tests::rigid_document()));
  json elastic = tests::elastic_document();
  elastic["physics"]["domain"]["layer_height"] = 0.25;
  elastic["physics"]["grid"]["ny_solid"] = 4;
  EXPECT_NE(id_of(elastic), id_of(tests::elastic_document()));
}

/// A parameter that a later version adds, with a default that means "as before", changes no id: it is dropped
/// before hashing. Shown with the text that is hashed.
TEST(CaseId, OnlyWhatDiffersFromTheDefaultIsHashed) {
  json physics = tests::elastic_document().at("physics");
  physics["solid"].update({{"formulation", "transported_B"},
                           {"interface", "weno"},
                           {"stiffness", "explicit"}});  // the first defaults
  json whole = {{"physics", physics}};
  case_schema().fill_defaults(whole);
  whole = case_schema().without_defaults(whole);
  EXPECT_EQ(
      canonical_text(whole.at("physics")),
      R"({"flow":"elastic_wall","grid":{"nx":32,"ny_fluid":32,"ny_solid":8,"nz":16},"solid":{"G":0.5}})");
}

/// Ids of released versions: when this fails, every finished case in the world has been orphaned. Do not
/// "fix" it by writing the new ids here.
TEST(CaseId, NeverChanges) {
  EXPECT_EQ(
      case_id(json::parse(R"({"flow": "rigid_channel", "grid": {"nx": 32, "ny_fluid": 24, "nz": 16}})")),
      "1898238d1a454764");
  EXPECT_EQ(
      case_id(json::parse(
          R"({"flow": "elastic_wall", "solid": {"G": 0.5, "formulation": "transported_B", "interface": "weno", "stiffness": "explicit"},
                                    "grid": {"nx": 32, "ny_fluid": 32, "ny_solid": 8, "nz": 16}})")),
      "027084d3ff65cafd");
  EXPECT_EQ(case_id(json::parse(R"({
              "flow": "elastic_wall", "reynolds": 3000.5,
              "domain": {"length_x": 7, "length_z": 2.5, "layer_height": 0.75},
              "grid": {"nx": 33, "ny_fluid": 32, "ny_solid": 20, "nz": 17, "stretching": 1.25},
              "solid": {"G": 0.3, "viscosity_ratio": 0.1, "formulation": "transported_B", "interface": "weno", "weno": "js", "threshold": 0.7,
                        "min_eigenvalue": 0.001, "stiffness": "explicit"},
              "time_step": {"fixed_dt": 0.001, "safety": 0.5},
              "initial": {"type": "precursor", "amplitude": 0.2, "seed": 7, "precursor": "0123456789abcdef",
                          "precursor_time": 12.5},
              "statistics": {"start_time": 2, "interval_steps": 3, "block_length": 0.25}})")),
            "716ef13be38d813d");
}

/// The default has changed from the one to the other; each keeps its own id.
TEST(CaseId, AChangedDefaultGivesNoOldIdToNewPhysics) {
  json first = tests::elastic_document(), second = first, absent = first;
  first["physics"]["solid"]["formulation"] = "transported_B";
  first["physics"]["solid"]["stiffness"] = "explicit";
  first["physics"]["solid"]["interface"] = "weno";
  second["physics"]["solid"]["formulation"] = "reference_map";
  second["physics"]["solid"]["stiffness"] = "implicit";
  EXPECT_EQ(id_of(first), "027084d3ff65cafd");
  EXPECT_NE(id_of(second), id_of(first));
  EXPECT_EQ(id_of(absent), id_of(second));
}

TEST(CaseId, TheInterfaceIsNoPartOfACaseWithAReferenceMap) {
  json document = tests::elastic_document();
  const std::string id = id_of(document);
  for (const char* interface : {"weno", "height"}) {
    document["physics"]["solid"]["interface"] = interface;
    EXPECT_EQ(id_of(document), id);
  }
  document["physics"]["solid"]["formulation"] = "transported_B";
  const std::string under_a_height = id_of(document);
  document["physics"]["solid"].erase("interface");
  EXPECT_EQ(id_of(document), under_a_height);
  EXPECT_NE(under_a_height, "027084d3ff65cafd") << "the id of the same with weno, the first default";
}

/// What ids rest on. A default that changed would give old ids to new physics, and no id would tell, unless
/// the schema keeps the first one as identity_default. A new parameter needs a new line.
TEST(CaseId, DefaultsNeverChange) {
  EXPECT_EQ(case_schema().part(json::json_pointer("/physics/solid/formulation"))->at("identity_default"),
            "transported_B");
  EXPECT_EQ(case_schema().part(json::json_pointer("/physics/solid/stiffness"))->at("identity_default"),
            "explicit");
  EXPECT_EQ(case_schema().part(json::json_pointer("/physics/solid/interface"))->at("identity_default"),
            "weno");
  json whole = {{"physics",
                 {{"flow", "elastic_wall"},
                  {"grid", json::object()},
                  {"solid", json::object()},
                  {"wave", json::object()}}}};
  case_schema().fill_defaults(whole);
  EXPECT_EQ(whole.at("physics"), json::parse(R"({
              "flow": "elastic_wall", "reynolds": 2800,
              "domain": {"length_x": 6, "length_z": 3, "layer_height": 0.5, "height": 2},
              "grid": {"ny_solid": 0, "stretching": 0}, "precision": "double",
              "solid": {"viscosity_ratio": 1, "formulation": "reference_map", "weno": "z", "interface": "height",
                        "threshold": 0.9, "extension": "column", "min_eigenvalue": 1e-4, "stiffness": "implicit",
                        "mooney_share": 0, "dt_plus": 0},
              "wave": {"displacement": 1e-4, "mean_flow": "none"},
              "time_step": {"safety": 0.8, "viscosity": "explicit"},
              "initial": {"type": "perturbed_laminar", "amplitude": 0.1, "seed": 1, "precursor": "",
                          "precursor_time": 0},
              "statistics": {"start_time": 0, "interval_steps": 10, "block_length": 1}})"));
}

TEST(CaseId, LabelAndRunAreNotIdentity) {
  json document = tests::elastic_document();
  document["label"] = "another";
  document["run"] = {{"end_time", 99}, {"keep_checkpoints", 5}, {"initial_checkpoint", "x"}};
  EXPECT_EQ(id_of(document), id_of(tests::elastic_document()));
}

TEST(CaseId, RefusesWhatIsNoNumber) {
  json physics = tests::elastic_document().at("physics");
  physics["reynolds"] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(case_id(physics)), std::invalid_argument);
}

TEST(CanonicalText, IsShortestAndUnambiguous) {
  EXPECT_EQ(canonical_text(json::parse(R"({"b": [1, 2.50, "x\"y"], "a": {}, "c": [], "d": true})")),
            R"({"a":{},"b":[1,2.5,"x\"y"],"c":[],"d":true})");
  EXPECT_EQ(canonical_text(json(0.1)), "0.1");
  EXPECT_EQ(canonical_text(json(1e22)), "1e+22");
}

}  // namespace
}  // namespace softwall
