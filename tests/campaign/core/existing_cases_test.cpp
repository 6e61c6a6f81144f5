#include "campaign/core/existing_cases.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "solver/case/case_id.hpp"
#include "tests/campaign/core/examples.hpp"

/// The averaging window is no part of a new case, and cases of earlier versions, whose ids hold it, are found
/// again.
namespace softwall::campaign {
namespace {

using nlohmann::json;
using tests::campaign_of;
using tests::elastic_campaign;

json physics_of(const CampaignCase& one) { return to_json(one.definition).at("physics"); }

std::vector<std::string> ids_of(const Campaign& campaign) {
  std::vector<std::string> ids;
  for (const CampaignCase& one : campaign.cases) ids.push_back(one.definition.id);
  return ids;
}

json with_window(double start, double block_length = 1) {
  json document = elastic_campaign();
  document["physics"]["statistics"] = {{"start_time", start}, {"block_length", block_length}};
  return document;
}

/// The physics of the cases as versions up to 0.1.0 wrote them: their statistics began with the averages, and
/// stability alone limited their steps.
std::vector<json> as_earlier_versions_had_it(const Campaign& campaign) {
  std::map<std::string, std::string> earlier_id;
  std::vector<json> all;
  for (const CampaignCase& one : campaign.cases) {
    json physics = physics_of(one);
    physics["statistics"]["start_time"] = one.window_start;
    if (physics.contains("solid")) physics["solid"]["dt_plus"] = 0;
    if (!one.precursor_id.empty()) physics["initial"]["precursor"] = earlier_id.at(one.precursor_id);
    earlier_id[one.definition.id] = case_id(physics);
    all.push_back(std::move(physics));
  }
  return all;
}

ExistingCases existing(const std::vector<json>& physics) {
  ExistingCases all;
  for (const json& each : physics) all.add(each);
  return all;
}

TEST(ExistingCases, AnotherWindowIsTheSameNewCase) {
  EXPECT_EQ(ids_of(campaign_of(with_window(10))), ids_of(campaign_of(with_window(20))));
  EXPECT_EQ(campaign_of(with_window(20)).cases.back().window_start, 20.0);
  EXPECT_NE(ids_of(campaign_of(with_window(10, 1))), ids_of(campaign_of(with_window(10, 2))));
}

TEST(ExistingCases, LongerBlocksAreMergedFromShorterOnes) {
  const Campaign first = campaign_of(with_window(10, 2));
  ExistingCases there;
  for (const auto& one : first.cases) there.add(physics_of(one));
  EXPECT_EQ(ids_of(parse_campaign(with_window(10, 6).dump(), "", there)), ids_of(first));
  EXPECT_NE(ids_of(parse_campaign(with_window(10, 1).dump(), "", there)), ids_of(first));
  EXPECT_NE(ids_of(parse_campaign(with_window(10, 3).dump(), "", there)), ids_of(first));
}

TEST(ExistingCases, StepsBetweenSamplesStayAPartOfTheCase) {
  json other = with_window(10);
  other["physics"]["statistics"]["interval_steps"] = 3;
  EXPECT_NE(ids_of(campaign_of(other)), ids_of(campaign_of(with_window(10))));
}

TEST(ExistingCases, AnEarlierCaseServesEveryWindowInItsBlocks) {
  const auto earlier = as_earlier_versions_had_it(campaign_of(with_window(10)));
  std::vector<std::string> ids;
  for (const json& physics : earlier) ids.push_back(case_id(physics));
  for (const double start : {10.0, 25.0, 5.0}) {  // of the last, only what there is from 10 on
    const Campaign now = parse_campaign(with_window(start).dump(), "", existing(earlier));
    EXPECT_EQ(ids_of(now), ids) << start;
    EXPECT_EQ(now.cases.back().definition.physics.statistics.start_time, 10.0);
    EXPECT_EQ(now.cases.back().window_start, start);
  }
}

/// A wider sweep starts its new cases from the precursor that is there.
TEST(ExistingCases, NewCasesStartFromAnEarlierPrecursor) {
  const auto earlier = as_earlier_versions_had_it(campaign_of(with_window(10)));
  json wider = with_window(10);
  wider["sweep"]["grid"]["G"] = {1, 2, 3};
  const Campaign now = parse_campaign(wider.dump(), "", existing(earlier));
  const CampaignCase& added = now.cases.back();
  EXPECT_EQ(added.definition.physics.solid->G, 3.0);
  EXPECT_EQ(added.definition.physics.initial.precursor, case_id(earlier.front()));
  EXPECT_EQ(added.definition.physics.statistics.start_time, 0.0) << "it keeps all its blocks";
}

TEST(ExistingCases, TheOneThatCoversTheWindowIsPreferred) {
  const json wanted = physics_of(campaign_of(with_window(20)).cases.back());
  const auto starting_at = [&](double start) {
    json physics = wanted;
    physics["statistics"]["start_time"] = start;
    return physics;
  };
  json asking = wanted;
  asking["statistics"]["start_time"] = 20;
  EXPECT_EQ(existing({starting_at(30), starting_at(15)}).continuation_of(asking, false).statistics.start_time,
            15.0);
  EXPECT_EQ(existing({starting_at(15), starting_at(0)}).continuation_of(asking, false).statistics.start_time,
            0.0);
  EXPECT_EQ(existing({starting_at(40), starting_at(30)}).continuation_of(asking, false).statistics.start_time,
            30.0);
  EXPECT_EQ(existing({}).continuation_of(asking, false).statistics.start_time, 0.0);
}

TEST(ExistingCases, AnEarlierCaseKeepsItsSteps) {
  const auto earlier = as_earlier_versions_had_it(campaign_of(with_window(10)));
  json wider = with_window(10);
  wider["sweep"]["grid"]["G"] = {1, 2, 3};
  const auto dt_plus = [](const CampaignCase& one) { return one.definition.physics.solid->dt_plus; };
  const Campaign now = parse_campaign(wider.dump(), "", existing(earlier));
  EXPECT_EQ(case_id(earlier[1]), now.cases[1].definition.id);
  EXPECT_EQ(dt_plus(now.cases[1]), 0.0);
  EXPECT_EQ(dt_plus(now.cases.back()), 0.4) << "a new case has the campaign's default";
  EXPECT_EQ(dt_plus(campaign_of(wider).cases[1]), 0.4);
  json asked = wider;
  asked["physics"]["solid"]["dt_plus"] = 0.4;
  EXPECT_EQ(dt_plus(parse_campaign(asked.dump(), "", existing(earlier)).cases[1]), 0.4);
}

TEST(ExistingCases, OneWithTheStepsWantedIsPreferred) {
  const json wanted = physics_of(campaign_of(with_window(20)).cases.back());
  json other = wanted;
  other["solid"]["dt_plus"] = 0;
  EXPECT_EQ(existing({other, wanted}).continuation_of(wanted, true).dt_plus, 0.4);
  EXPECT_EQ(existing({wanted, other}).continuation_of(wanted, true).dt_plus, 0.4);
  EXPECT_EQ(existing({other}).continuation_of(wanted, true).dt_plus, 0.0);
  EXPECT_EQ(existing({other}).continuation_of(wanted, false).dt_plus, 0.4);
}

TEST(ExistingCases, StepsOfFixedLengthHaveNoLimit) {
  json fixed = with_window(10);
  fixed["physics"]["time_step"]["fixed_dt"] = 0.01;
  EXPECT_EQ(campaign_of(fixed).cases.back().definition.physics.solid->dt_plus, 0.0);
}

/// Ids that the campaigns in runs/ had before the window left them, recorded then. A campaign file that is
/// changed on purpose takes its new ids in there; one that is not keeps them, or its finished cases are lost.
TEST(ExistingCases, FinishedCasesOfTheCommittedCampaignsAreKept) {
  std::ifstream file(SOFTWALL_RECORDED_IDS);
  const json recorded = json::parse(file);
  EXPECT_EQ(recorded.size(), 15U);
  for (const auto& [name, ids] : recorded.items()) {
    const auto path = std::filesystem::path(SOFTWALL_RUNS_FOLDER).parent_path() / name;
    const auto earlier = as_earlier_versions_had_it(read_campaign(path));
    EXPECT_EQ(ids_of(read_campaign(path, existing(earlier))), ids.get<std::vector<std::string>>()) << name;
  }
}

}  // namespace
}  // namespace softwall::campaign
