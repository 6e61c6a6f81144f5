#include "campaign/core/derive.hpp"

#include <gtest/gtest.h>

#include "tests/campaign/core/examples.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;
using tests::campaign_of;
using tests::complaint_about;
using tests::labels;

/// A channel whose layer, Reynolds number and sweep are left to the test.
json channel(const char* sweep, const char* derive) {
  json document = json::parse(R"({
    "format": 1, "name": "derived",
    "physics": {"grid": {"nx": 48, "ny_fluid": 64, "nz": 48}},
    "run": {"end_time": 50, "checkpoint_steps": 10}})");
  document["sweep"] = json::parse(sweep);
  document["derive"] = json::parse(derive);
  return document;
}

TEST(Derive, WritesTheResultIntoTheCase) {
  const auto campaign = campaign_of(channel(R"({"grid": {"G": [0.5, 1], "ny_fluid": [64, 128]}})",
                                            R"({"ny_solid": "ny_fluid / 4", "reynolds": "2800 * G"})"));
  ASSERT_EQ(campaign.cases.size(), 4U);
  const Physics& last = campaign.cases[3].definition.physics;
  EXPECT_EQ(last.grid.ny_fluid, 128);
  EXPECT_EQ(last.grid.ny_solid, 32);
  EXPECT_EQ(last.reynolds, 2800);
  EXPECT_EQ(campaign.cases[0].definition.physics.grid.ny_solid, 16);
  EXPECT_EQ(campaign.cases[0].definition.physics.reynolds, 1400);
}

TEST(Derive, GivesTheCaseThatIsWrittenByHand) {
  const auto derived = campaign_of(channel(R"({"grid": {"G": [0.1, 0.3]}})",
                                           R"({"ny_solid": "ny_fluid / 4", "viscosity_ratio": "3 * G"})"));
  const auto written = campaign_of(
      channel(R"({"zip": {"G": [0.1, 0.3], "ny_solid": [16, 16], "viscosity_ratio": [0.3, 0.9]}})", "{}"));
  ASSERT_EQ(derived.cases.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(derived.cases[i].definition.id, written.cases[i].definition.id) << "0.1 * 3 is 0.3";
    EXPECT_EQ(derived.cases[i].directory, written.cases[i].directory);
    EXPECT_EQ(derived.cases[i].varied, written.cases[i].varied);
  }
  EXPECT_EQ(labels(derived), "G=0.1_mu=0.3 G=0.3_mu=0.9") << "the layer's cells are the same for all";
}

TEST(Derive, OfASingleCaseIsNotNamed) {
  EXPECT_EQ(labels(campaign_of(channel("{}", R"({"ny_solid": "ny_fluid / 4", "G": "2 * 1"})"))),
            "elastic_wall");
  EXPECT_EQ(labels(campaign_of(channel(R"({"list": [{"G": 2}]})", R"({"ny_solid": "ny_fluid / 4"})"))),
            "G=2");
}

TEST(Derive, ReadsDefaultsAndWhatIsDerivedItself) {
  const auto campaign = campaign_of(channel(
      R"({"list": [{"G": 2}]})",
      R"({"ny_solid": "ny_fluid / 4", "seed": "ny_solid + grid.nx", "reynolds": "length_z / length_z * 100 * solid.G"})"));
  const Physics& physics = campaign.cases.front().definition.physics;
  EXPECT_EQ(physics.initial.seed, 64U);
  EXPECT_EQ(physics.reynolds, 200);
}

TEST(Derive, MayGiveWhatEveryCaseNeeds) {
  json document = channel(R"({"grid": {"G": [1], "ny_fluid": [32, 64]}})",
                          R"({"ny_solid": "ny_fluid / 4", "nx": "2 * nz", "ny_fluid": "1"})");
  document["physics"]["grid"] = {{"ny_fluid", 64}, {"nz", 24}};
  document["derive"].erase("ny_fluid");
  EXPECT_EQ(campaign_of(document).cases[0].definition.physics.grid.nx, 48);
  document["derive"].erase("nx");
  EXPECT_NE(complaint_about(document).find("/physics/grid/nx: missing"), std::string::npos);
}

TEST(Derive, ReachesThePrecursor) {
  json document =
      channel(R"({"grid": {"G": [1, 2]}})", R"({"ny_solid": "ny_fluid / 4", "reynolds": "1400 * G"})");
  document["precursor"] = {{"run", {{"end_time", 10}}}};
  const auto campaign = campaign_of(document);
  ASSERT_EQ(campaign.cases.size(), 4U);
  EXPECT_EQ(campaign.cases[0].definition.physics.reynolds, 1400);
  EXPECT_EQ(campaign.cases[1].definition.physics.reynolds, 2800);
  EXPECT_EQ(campaign.cases[1].definition.physics.grid.ny_solid, 0);
  EXPECT_EQ(campaign.cases[3].precursor_id, campaign.cases[1].definition.id);
}

TEST(Derive, MayBeExcludedBy) {
  const auto campaign =
      campaign_of(channel(R"({"grid": {"G": [0, 1, 2]}, "exclude": [{"G": 0}, {"reynolds": 2800}]})",
                          R"({"ny_solid": "ny_fluid / 4", "reynolds": "2800 / G"})"));
  EXPECT_EQ(labels(campaign), "G=2") << "what is excluded need not be derived";
}

struct Refusal {
  const char* sweep;
  const char* derive;
  const char* said;
};

TEST(Derive, RefusesInWordsThatHelp) {
  const Refusal refusals[] = {
      {"{}", R"({"ny_sold": "1"})", "/derive/ny_sold: no such parameter; did you mean \"ny_solid\"?"},
      {"{}", R"({"ny_solid": "ny_fluit / 4"})",
       "/derive/ny_solid: no such parameter: ny_fluit; did you mean \"ny_fluid\"?"},
      {"{}", R"({"ny_solid": "ny_fluid // 4"})",
       "/derive/ny_solid: \"ny_fluid // 4\"; expected a number, a parameter or \"(\" at character 11, \"/ "
       "4\""},
      {R"({"grid": {"G": [1]}})", R"({"ny_solid": "16", "solid.G": "2"})",
       "/derive/solid.G: is swept as well; derive it, or leave it in /sweep/grid"},
      {R"({"list": [{"solid.G": 1}]})", R"({"ny_solid": "16", "G": "2"})",
       "/derive/G: is swept as well; derive it, or leave it in /sweep/list"},
      {R"({"list": [{"G": 1}]})", R"({"ny_solid": "16", "nz": "2"})",
       "/derive/nz: is fixed as well; derive it, or leave it in /physics/grid/nz"},
      {R"({"list": [{"G": 1}]})", R"({"ny_solid": "16", "grid.ny_solid": "16"})",
       "the same parameter under two names; name it once"},
      {R"({"list": [{"G": 1}]})", R"({"ny_solid": "ny_solid"})",
       "/derive/ny_solid: needs itself; ny_solid needs ny_solid"},
      {R"({"list": [{"G": 1}]})", R"({"ny_solid": "seed", "seed": "reynolds", "reynolds": "ny_solid"})",
       "needs itself; ny_solid needs seed needs reynolds needs ny_solid"},
      {R"({"list": [{"G": 1}]})", R"({"ny_solid": "ny_fluid / 7"})",
       "/derive/ny_solid: 9.14285714285714 from \"ny_fluid / 7\"; must be an integer from 0"},
      {R"({"list": [{"G": 1}]})", R"({"ny_solid": "16", "reynolds": "-G"})",
       "/derive/reynolds: -1 from \"-G\"; must be a number from"},
      {R"({"list": [{"G": 1}]})", R"d({"ny_solid": "16", "reynolds": "1 / (G - 1)"})d",
       "/derive/reynolds: \"1 / (G - 1)\"; divides by zero"},
      {R"({"list": [{"G": 1e300}]})", R"({"ny_solid": "16", "reynolds": "G * G"})",
       "/derive/reynolds: \"G * G\"; is not a finite number"},
      {R"({"list": [{"G": 1}]})", R"({"ny_solid": "16", "reynolds": "decay"})",
       "/derive/reynolds: \"decay\"; needs decay, which this case has not"},
      {R"({"list": [{"G": 1}]})", R"({"ny_solid": "16", "reynolds": "formulation"})",
       "needs formulation, which is no number but \"reference_map\""},
      {R"({"grid": {"G": [1, 2]}})", R"d({"ny_solid": "round(8 * G) + 0.5"})d",
       "/derive/ny_solid: 8.5 from \"round(8 * G) + 0.5\"; must be an integer from 0 to 100000 (case G=1)"},
      {"{}", R"({"ny_solid": 16})", "/derive/ny_solid: 16; must be "},
      {"{}", R"({"ny_solid": ""})", "/derive/ny_solid: \"\"; must be "},
      {"{}", R"(["ny_solid"])", "/derive: "},
  };
  for (const auto& [sweep, derive, said] : refusals)
    EXPECT_NE(complaint_about(channel(sweep, derive)).find(said), std::string::npos)
        << derive << "\n"
        << complaint_about(channel(sweep, derive));
}

/// The height of the layer is no part of a rigid channel.
TEST(Derive, IsRefusedWhereItHasNoEffect) {
  json document = channel("{}", R"({"layer_height": "0.25 * 2", "reynolds": "100 + 1"})");
  document["physics"]["flow"] = "rigid_channel";
  EXPECT_NE(complaint_about(document).find(
                "/derive/layer_height: \"0.25 * 2\"; has no effect: no case has such a value, leave it out"),
            std::string::npos)
      << complaint_about(document);
  EXPECT_EQ(complaint_about(document).find("/derive/reynolds"), std::string::npos);
}

/// A reference map has no threshold.
TEST(Derive, IsRefusedWhereItChangesTheIdAlone) {
  const json document = channel(R"({"list": [{"G": 1}]})", R"({"ny_solid": "16", "threshold": "0.5 * G"})");
  EXPECT_NE(complaint_about(document).find("/derive/threshold: \"0.5 * G\"; has no effect"),
            std::string::npos)
      << complaint_about(document);
}

/// Two points that differ in nothing that matters, and in what is derived from it: the sweep is to blame.
TEST(Derive, DoesNotHideASweepWithoutEffect) {
  json document =
      channel(R"({"grid": {"layer_height": [0.5, 1]}})", R"({"reynolds": "100 + 0 * layer_height"})");
  document["physics"]["flow"] = "rigid_channel";
  const std::string complaint = complaint_about(document);
  EXPECT_NE(complaint.find("/sweep: domain/layer_height"), std::string::npos) << complaint;
}

}  // namespace
}  // namespace softwall::campaign
