#include "campaign/core/expand.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "solver/case/case_id.hpp"
#include "tests/campaign/core/examples.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;
using tests::campaign_of;
using tests::complaint_about;
using tests::elastic_campaign;
using tests::labels;

TEST(Expand, PrecursorFirstThenEveryPoint) {
  const Campaign campaign = campaign_of(elastic_campaign());
  EXPECT_EQ(labels(campaign), "precursor G=1_mu=0.1 G=1_mu=1 G=2_mu=0.1 G=2_mu=1");
  const CampaignCase& precursor = campaign.cases.front();
  EXPECT_TRUE(precursor.is_precursor);
  EXPECT_EQ(precursor.precursor_id, "");
  EXPECT_EQ(precursor.definition.physics.flow, FlowType::kRigidChannel);
  EXPECT_FALSE(precursor.definition.physics.solid);
  EXPECT_EQ(precursor.definition.physics.grid.nx, 32);  // its own
  EXPECT_EQ(precursor.definition.physics.grid.nz, 48);  // the common one
  EXPECT_EQ(precursor.definition.physics.grid.ny_solid, 0);
  EXPECT_EQ(precursor.definition.physics.time_step.safety, 0.7);
  EXPECT_EQ(precursor.window_start, 50.0);
  EXPECT_EQ(precursor.definition.physics.statistics.start_time, 0.0) << "blocks are kept from the start";
  EXPECT_EQ(precursor.definition.run.end_time, 100.0);
  EXPECT_EQ(precursor.definition.run.checkpoint_steps, 10);  // the common one
  for (std::size_t i = 1; i < campaign.cases.size(); ++i) {
    const CampaignCase& c = campaign.cases[i];
    EXPECT_FALSE(c.is_precursor);
    EXPECT_EQ(c.precursor_id, precursor.definition.id);
    EXPECT_EQ(c.definition.physics.flow, FlowType::kElasticWall);
    EXPECT_EQ(c.definition.physics.grid.nx, 48);
    EXPECT_EQ(c.definition.physics.initial.type, InitialType::kPrecursor);
    EXPECT_EQ(c.definition.physics.initial.precursor, precursor.definition.id);
    EXPECT_EQ(c.definition.physics.initial.precursor_time, 100.0);
    EXPECT_EQ(c.definition.physics.statistics.start_time, 0.0);
    EXPECT_EQ(c.definition.run.end_time, 50.0);
  }
  EXPECT_EQ(campaign.cases[3].definition.physics.solid->G, 2.0);
  EXPECT_EQ(campaign.cases[3].definition.physics.solid->viscosity_ratio, 0.1);
}

/// Planes in the layer are none of its channel's.
TEST(Expand, APrecursorFilmsTheSamePlanesOfItsChannel) {
  json document = elastic_campaign();
  document["run"]["plane_interval"] = 0.5;
  document["run"]["planes"] = {{"x", {3}}, {"y", {1, 2, 2.25}}};
  const auto films = [](const Campaign& campaign) {
    return std::pair(campaign.cases.front().definition.run, campaign.cases.back().definition.run);
  };
  const auto [precursor, wall] = films(campaign_of(document));
  EXPECT_EQ(precursor.plane_interval, 0.5);
  EXPECT_EQ(precursor.planes.x, std::vector<double>{3});
  EXPECT_EQ(precursor.planes.y, (std::vector<double>{1, 2}));
  EXPECT_EQ(wall.planes.y, (std::vector<double>{1, 2, 2.25}));
  document["precursor"]["run"]["planes"] = {{"y", {0.1}}};
  EXPECT_EQ(films(campaign_of(document)).first.planes.y, std::vector<double>{0.1});
  document["precursor"]["run"]["planes"]["y"] = {2.25};
  EXPECT_NE(complaint_about(document).find("/run/planes/y/0: 2.25; beyond the end of the box"),
            std::string::npos)
      << complaint_about(document);
}

TEST(Expand, IdsAreThoseOfTheWrittenCases) {
  std::set<std::string> ids, directories;
  for (const auto& c : campaign_of(elastic_campaign()).cases) {
    EXPECT_EQ(parse_case(to_json(c.definition).dump()).id, c.definition.id);
    EXPECT_EQ(c.directory, "cases/" + c.definition.label + "-" + c.definition.id.substr(0, 8));
    ids.insert(c.definition.id);
    directories.insert(c.directory);
  }
  EXPECT_EQ(ids.size(), 5U);
  EXPECT_EQ(directories.size(), 5U);
}

TEST(Expand, EqualCasesAreOne) {
  json document = elastic_campaign();
  document["sweep"] = json::parse(
      R"({"grid": {"G": [1, 1.0, 2]}, "list": [{"G": 1, "viscosity_ratio": 1}, {"solid.G": 2}]})");
  EXPECT_EQ(labels(campaign_of(document)), "precursor G=1 G=2");
}

TEST(Expand, ExclusionsApplyToDefaultsToo) {
  json document = elastic_campaign();
  document["sweep"] = json::parse(
      R"({"list": [{"G": 1}, {"G": 2}, {"G": 2, "viscosity_ratio": 3}], "exclude": [{"G": 2, "viscosity_ratio": 1}]})");
  EXPECT_EQ(labels(campaign_of(document)), "precursor G=1_mu=1 G=2_mu=3");
  document["sweep"]["exclude"] = json::parse(R"([{"reynolds": 2800}])");
  EXPECT_NE(complaint_about(document).find("excludes every case"), std::string::npos);
}

TEST(Expand, LabelsNameWhatVaries) {
  json document = elastic_campaign();
  document["sweep"] =
      json::parse(R"({"grid": {"G": [1e20, 1e-20, 0.30000000000000004], "viscosity_ratio": [3]}})");
  EXPECT_EQ(labels(campaign_of(document)), "precursor G=1e20 G=1e-20 G=0.30000000000000004");
  document["sweep"] = json::parse(R"({"grid": {"G": [2], "viscosity_ratio": [3]}})");
  EXPECT_EQ(labels(campaign_of(document)), "precursor G=2_mu=3");  // nothing varies: what the sweep sets
}

TEST(Expand, LabelsAreDistinctHoweverManyParametersVary) {
  json document = elastic_campaign();
  document["physics"]["solid"] = {{"formulation", "transported_B"}};
  document["sweep"]["grid"] = json::object();
  for (const char* name :
       {"G", "viscosity_ratio", "reynolds", "safety", "threshold", "length_z", "min_eigenvalue"})
    document["sweep"]["grid"][name] = {0.51234567890123, 0.61234567890123};
  const Campaign campaign = campaign_of(document);
  std::set<std::string> labels;
  for (const auto& c : campaign.cases) {
    labels.insert(c.definition.label);
    EXPECT_LE(c.definition.label.size(), 80U);
  }
  EXPECT_EQ(labels.size(), campaign.cases.size());
}

TEST(Expand, EverySeedHasItsPrecursor) {
  json document = elastic_campaign();
  document["sweep"] = json::parse(R"({"grid": {"seed": [1, 2, 3]}})");
  document["physics"]["solid"] = {{"G", 1}};
  const Campaign campaign = campaign_of(document);
  EXPECT_EQ(labels(campaign), "precursor_seed=1 precursor_seed=2 precursor_seed=3 seed=1 seed=2 seed=3");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(campaign.cases[i].definition.physics.initial.seed, i + 1);
    EXPECT_EQ(campaign.cases[3 + i].precursor_id, campaign.cases[i].definition.id);
  }
}

TEST(Expand, RefusesToSweepWhatHasNoEffect) {
  json document = elastic_campaign();
  document["sweep"] = json::parse(R"({"grid": {"seed": [1, 2]}})");
  document["physics"]["solid"] = {{"G", 1}};
  document["precursor"]["initial"] = {{"seed", 7}};  // wins over the sweep's
  EXPECT_NE(complaint_about(document).find("/sweep: initial/seed: 1 and 2; give the same case"),
            std::string::npos)
      << complaint_about(document);
  document = elastic_campaign();
  document.erase("precursor");
  document["physics"]["flow"] = "rigid_channel";
  document["physics"]["grid"]["ny_solid"] = 0;
  document["sweep"] = json::parse(R"({"grid": {"layer_height": [0.5, 1]}})");
  EXPECT_NE(complaint_about(document).find("layer_height: 0.5 and 1; give the same case"), std::string::npos)
      << complaint_about(document);
}

TEST(Expand, RefusesToSweepWhatHasAnIdOfItsOwnButNoEffect) {
  const auto said_of = [](const char* sweep, const std::function<void(json&)>& change) {
    json document = elastic_campaign();
    document.erase("precursor");
    document["physics"]["solid"] = {{"G", 1}};
    document["sweep"] = json::parse(sweep);
    change(document["physics"]);
    return complaint_about(document);
  };
  const auto nothing = [](json&) {};
  for (const char* sweep :
       {R"({"grid": {"threshold": [0.2, 0.9]}})", R"({"grid": {"min_eigenvalue": [0.01, 0.1]}})",
        R"({"grid": {"extension": ["column", "normal"]}})",
        R"({"list": [{"G": 1}, {"G": 2}, {"G": 2, "threshold": 0.3}]})"})
    EXPECT_NE(said_of(sweep, nothing).find("give the same case"), std::string::npos) << sweep;
  EXPECT_EQ(said_of(R"({"grid": {"threshold": [0.2, 0.9]}})",
                    [](json& physics) { physics["solid"]["formulation"] = "transported_B"; }),
            "");
  EXPECT_NE(said_of(R"({"grid": {"safety": [0.5, 0.6]}})",
                    [](json& physics) { physics["time_step"]["fixed_dt"] = 0.01; })
                .find("time_step/safety: 0.5 and 0.6"),
            std::string::npos);
  EXPECT_NE(
      said_of(R"({"grid": {"seed": [1, 2]}})", [](json& physics) { physics["initial"]["amplitude"] = 0; })
          .find("initial/seed: 1 and 2"),
      std::string::npos);
}

TEST(Expand, RefusesExclusionsThatExcludeNothing) {
  json document = elastic_campaign();
  document["sweep"] = json::parse(R"({"grid": {"G": [0.1, 0.30000000000000004, 2]},
    "exclude": [{"G": 0.1}, {"G": 0.3}, {"G": 7}, {"G": "2"}, {"G": 2, "reynolds": 2800, "viscosity_ratio": 5}]})");
  const std::string message = complaint_about(document);
  for (const char* part :
       {"/sweep/exclude/1/G: 0.3; excludes nothing: no case has this value; the nearest is "
        "0.30000000000000004",
        "/sweep/exclude/2/G: 7; excludes nothing", "/sweep/exclude/3/G: \"2\"; excludes nothing",
        "/sweep/exclude/4/viscosity_ratio: 5; excludes nothing"})
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  EXPECT_EQ(message.find("/sweep/exclude/0"), std::string::npos) << message;
}

TEST(Expand, RefusesAveragesThatStartAfterTheEnd) {
  json document = elastic_campaign();
  document["physics"]["statistics"]["start_time"] = 60;
  document["precursor"]["statistics"]["start_time"] = 100;
  const std::string message = complaint_about(document);
  for (const char* part :
       {"/physics/statistics/start_time: 60; must be less than the end time, 50",
        "/precursor: /physics/statistics/start_time: 100; must be less than the end time, 100"})
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

TEST(Expand, ThePointWinsOverTheCommonValue) {
  json document = elastic_campaign();
  document["physics"]["solid"] = {{"G", 9}, {"viscosity_ratio", 7}};
  document["sweep"] = json::parse(R"({"grid": {"G": [1]}})");
  const Case made = campaign_of(document).cases.back().definition;
  EXPECT_EQ(made.physics.solid->G, 1.0);
  EXPECT_EQ(made.physics.solid->viscosity_ratio, 7.0);
}

TEST(Expand, APrecursorPerFluid) {
  json document = elastic_campaign();
  document["physics"]["solid"] = {{"formulation", "transported_B"}};
  document["sweep"]["grid"] = {
      {"reynolds", {2800, 3000}}, {"G", {1, 2}}, {"threshold", {0.8, 0.9}}, {"safety", {0.6, 0.7}}};
  const Campaign campaign = campaign_of(document);
  EXPECT_EQ(campaign.cases.size(), 2U + 16U);
  EXPECT_EQ(campaign.cases[0].definition.label, "precursor_reynolds=2800");
  EXPECT_EQ(campaign.cases[1].definition.label, "precursor_reynolds=3000");
  EXPECT_TRUE(campaign.cases[1].is_precursor);
  for (std::size_t i = 2; i < campaign.cases.size(); ++i) {
    const bool second = campaign.cases[i].definition.physics.reynolds == 3000.0;
    EXPECT_EQ(campaign.cases[i].precursor_id, campaign.cases[second ? 1 : 0].definition.id);
  }
}

TEST(Expand, AGridStudyMayShareOnePrecursor) {
  json document = elastic_campaign();
  document["physics"]["solid"] = {{"G", 1}};
  document["precursor"]["grid"] = {{"nx", 32}, {"nz", 24}};
  document["sweep"]["grid"] = {{"nx", {32, 64}}, {"nz", {24, 48}}};
  EXPECT_EQ(campaign_of(document).cases.size(), 1U + 4U);
  document["precursor"].erase("grid");
  EXPECT_EQ(campaign_of(document).cases.size(), 4U + 4U);
}

/// Moving the layer's thickness or its cells changes no precursor.
TEST(Expand, TheLayerIsNoneOfThePrecursorsBusiness) {
  json document = elastic_campaign();
  const std::string id = campaign_of(document).cases.front().definition.id;
  document["physics"]["domain"]["layer_height"] = 0.25;
  document["physics"]["grid"]["ny_solid"] = 8;
  document["physics"]["solid"]["weno"] = "js";
  EXPECT_EQ(campaign_of(document).cases.front().definition.id, id);
  document["precursor"]["run"]["end_time"] = 120;
  const Campaign longer = campaign_of(document);
  EXPECT_EQ(longer.cases.front().definition.id, id);
  EXPECT_EQ(longer.cases.back().definition.physics.initial.precursor_time, 120.0);
}

TEST(Expand, WithoutAPrecursorCasesStartByThemselves) {
  json document = elastic_campaign();
  document.erase("precursor");
  document["physics"]["initial"] = {{"seed", 5}};
  const Campaign campaign = campaign_of(document);
  EXPECT_EQ(campaign.cases.size(), 4U);
  EXPECT_EQ(campaign.cases[0].precursor_id, "");
  EXPECT_EQ(campaign.cases[0].definition.physics.initial.type, InitialType::kPerturbedLaminar);
  EXPECT_EQ(campaign.cases[0].definition.physics.initial.seed, 5U);
}

TEST(Expand, RigidChannelsCanBeSwept) {
  json document = json::parse(
      R"({"format": 1, "name": "rigid", "run": {"end_time": 5}, "physics": {"flow": "rigid_channel",
      "grid": {"nx": 8, "ny_fluid": 8, "nz": 8}}, "sweep": {"grid": {"reynolds": [100, 200]}}})");
  EXPECT_EQ(labels(campaign_of(document)), "reynolds=100 reynolds=200");
  document.erase("sweep");
  EXPECT_EQ(labels(campaign_of(document)), "rigid_channel");
}

/// A fine grid may go on from a coarse one's turbulence.
TEST(Expand, RigidChannelsMayHaveAPrecursor) {
  json document = elastic_campaign();
  document["physics"]["flow"] = "rigid_channel";
  document["physics"]["grid"]["ny_solid"] = 0;
  document["physics"].erase("solid");
  document["sweep"] = {{"grid", {{"nx", {64, 96}}}}};
  const Campaign campaign = campaign_of(document);
  EXPECT_EQ(labels(campaign), "precursor nx=64 nx=96");
  EXPECT_EQ(campaign.cases[1].precursor_id, campaign.cases[0].definition.id);
  EXPECT_EQ(campaign.cases[1].definition.physics.initial.type, InitialType::kPrecursor);
}

TEST(Expand, ClosedBoxesStartByThemselves) {
  json document = elastic_campaign();
  document["physics"]["flow"] = "cavity";
  EXPECT_NE(complaint_about(document).find("a closed box starts by itself"), std::string::npos);
}

TEST(Expand, AWaveIsSweptWithItsLayers) {
  const json document = json::parse(R"({
    "format": 1, "name": "waves",
    "physics": {"flow": "interface_wave", "grid": {"nx": 32, "ny_fluid": 32, "ny_solid": 8, "nz": 1}},
    "sweep": {"zip": {"G": [1, 2], "decay": [0.0543952160378, 0.2], "frequency": [3.09964567747, 4.4]}},
    "run": {"end_time": 4}})");
  const std::string message = complaint_about(document);
  EXPECT_NE(message.find("/physics/wave: decay 0.2, frequency 4.4; not the rate"), std::string::npos)
      << message;
  EXPECT_NE(message.find("(case G=2_decay=0.2_frequency=4.4)"), std::string::npos) << message;
  json one = document;
  for (json& values : one["sweep"]["zip"]) values.erase(1);
  const Campaign campaign = campaign_of(one);
  ASSERT_EQ(campaign.cases.size(), 1U);
  EXPECT_EQ(campaign.cases.front().definition.physics.wave->frequency, 3.09964567747);
}

TEST(Expand, RanksComeFromExecution) {
  json document = elastic_campaign();
  document["execution"] = {{"ranks", 2}, {"precursor_ranks", 4}};
  const Campaign campaign = campaign_of(document);
  EXPECT_EQ(campaign.cases.front().ranks, 4);
  EXPECT_EQ(campaign.cases.back().ranks, 2);
}

TEST(Expand, CommonMistakesAreToldOnce) {
  json document = elastic_campaign();
  document["physics"]["grid"]["ny_solid"] = 17;
  const std::string message = complaint_about(document);
  EXPECT_EQ(message.find("/physics/grid/ny_solid"), message.rfind("/physics/grid/ny_solid")) << message;
  EXPECT_EQ(message.find("(case"), std::string::npos) << message;
}

TEST(Expand, MistakesOfSomeCasesNameThem) {
  json document = elastic_campaign();
  document["sweep"]["grid"]["G"] = {1, 0, "soft"};
  document["precursor"]["time_step"] = {{"fixed_dt", -1}};
  const std::string first = complaint_about(document);
  EXPECT_NE(first.find("/precursor/time_step/fixed_dt: -1"), std::string::npos) << first;
  document["precursor"].erase("time_step");
  const std::string message = complaint_about(document);
  EXPECT_NE(message.find("/physics/solid/G: 0; must be a number greater than 0 and of at most 1e+300 (case "
                         "G=0_mu=0.1, G=0_mu=1)"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("/physics/solid/G: \"soft\""), std::string::npos) << message;
}

/// Only the values that differ are looked at once a case has been found sound.
TEST(Expand, AMistakeAfterASoundCaseIsFoundToo) {
  json document = elastic_campaign();
  document["sweep"] =
      json::parse(R"({"grid": {"G": [1, 2, -3, "soft", 4]}, "list": [{"G": 5, "ny_solid": 2}]})");
  try {
    static_cast<void>(campaign_of(document));
    FAIL() << "accepted";
  } catch (const BadInput& error) {
    std::string found;
    for (const Mistake& mistake : error.mistakes) found += mistake.where + ": " + mistake.given + "\n";
    EXPECT_EQ(found, "/physics/solid/G: -3\n/physics/solid/G: \"soft\"\n/physics/grid/ny_solid: 2\n");
  }
}

/// The expansion must end within the time that ctest allows. With sanitizers there are fewer cases.
TEST(Expand, ManyCasesTakeLittleTime) {
#ifdef __SANITIZE_ADDRESS__
  constexpr std::size_t kSide = 20;
#else
  constexpr std::size_t kSide = 100;
#endif
  json document = elastic_campaign();
  for (std::size_t i = 0; i < kSide; ++i) {
    document["sweep"]["grid"]["G"][i] = 1 + i;
    document["sweep"]["grid"]["viscosity_ratio"][i] = 1 + i;
  }
  EXPECT_EQ(campaign_of(document).cases.size(), kSide * kSide + 1);
}

}  // namespace
}  // namespace softwall::campaign
