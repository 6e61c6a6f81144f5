#include "campaign/core/start_order.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/campaign/core/examples.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;
using tests::campaign_of;
using tests::complaint_about;
using tests::elastic_campaign;
using tests::labels;

json chained(const char* start_from = R"({"nearest": "G"})") {
  json document = elastic_campaign();
  document["sweep"] = json::parse(R"({"grid": {"G": [0.5, 2, 1], "viscosity_ratio": [0.1, 1]}})");
  document["start_from"] = json::parse(start_from);
  return document;
}

/// "G=2<precursor G=1<G=2": who starts from whom.
std::string starts(const Campaign& campaign) {
  std::map<std::string, std::string> label_of;
  for (const auto& one : campaign.cases) label_of[one.definition.id] = one.definition.label;
  std::string text;
  for (const auto& one : campaign.cases) {
    if (one.is_precursor) continue;
    text += (text.empty() ? "" : " ") + one.definition.label;
    if (!one.precursor_id.empty()) text += "<" + label_of.at(one.precursor_id);
  }
  return text;
}

const CampaignCase& labelled(const Campaign& campaign, const std::string& label) {
  for (const auto& one : campaign.cases)
    if (one.definition.label == label) return one;
  throw std::runtime_error("no case " + label);
}

TEST(StartFrom, EachStartsFromTheNextStifferWithTheSameOtherValues) {
  const Campaign campaign = campaign_of(chained());
  EXPECT_EQ(starts(campaign),
            "G=2_mu=0.1<precursor G=1_mu=0.1<G=2_mu=0.1 G=0.5_mu=0.1<G=1_mu=0.1 "
            "G=2_mu=1<precursor G=1_mu=1<G=2_mu=1 G=0.5_mu=1<G=1_mu=1");
  EXPECT_TRUE(labelled(campaign, "G=1_mu=1").starts_others);
  EXPECT_FALSE(labelled(campaign, "G=0.5_mu=1").starts_others);
  EXPECT_TRUE(labelled(campaign, "precursor").starts_others);
}

TEST(StartFrom, MayBeginWithTheSmallest) {
  const Campaign campaign = campaign_of(chained(R"({"nearest": "viscosity_ratio", "first": "smallest"})"));
  EXPECT_EQ(starts(campaign),
            "G=0.5_mu=0.1<precursor G=0.5_mu=1<G=0.5_mu=0.1 G=2_mu=0.1<precursor G=2_mu=1<G=2_mu=0.1 "
            "G=1_mu=0.1<precursor G=1_mu=1<G=1_mu=0.1");
}

/// The same wall from another start is another trajectory; the first of a line has the start it always had.
TEST(StartFrom, TheStartIsAPartOfTheIdentity) {
  json without = chained();
  without.erase("start_from");
  const Campaign one = campaign_of(chained()), other = campaign_of(without);
  EXPECT_EQ(labelled(one, "G=2_mu=1").definition.id, labelled(other, "G=2_mu=1").definition.id);
  EXPECT_NE(labelled(one, "G=1_mu=1").definition.id, labelled(other, "G=1_mu=1").definition.id);
  const InitialSpec& initial = labelled(one, "G=1_mu=1").definition.physics.initial;
  EXPECT_EQ(initial.type, InitialType::kNeighbour);
  EXPECT_EQ(initial.precursor, labelled(one, "G=2_mu=1").definition.id);
  EXPECT_EQ(initial.precursor_time, 50);
}

TEST(StartFrom, IdsFollowFromTheFileAloneWhateverTheOrderOfItsValues) {
  json shuffled = chained();
  shuffled["sweep"]["grid"]["G"] = {2, 0.5, 1};
  const Campaign one = campaign_of(chained()), other = campaign_of(shuffled);
  for (const auto& c : one.cases)
    EXPECT_EQ(labelled(other, c.definition.label).definition.id, c.definition.id) << c.definition.label;
}

/// A value put in between makes other cases of those behind it alone.
TEST(StartFrom, ANewValueChangesThoseThatComeAfterIt) {
  json more = chained();
  more["sweep"]["grid"]["G"] = {0.5, 2, 1, 0.75};
  const Campaign one = campaign_of(chained()), other = campaign_of(more);
  EXPECT_EQ(labelled(one, "G=1_mu=1").definition.id, labelled(other, "G=1_mu=1").definition.id);
  EXPECT_NE(labelled(one, "G=0.5_mu=1").definition.id, labelled(other, "G=0.5_mu=1").definition.id);
}

TEST(StartFrom, WithoutAPrecursorTheFirstStartsByItself) {
  json document = chained();
  document.erase("precursor");
  EXPECT_EQ(starts(campaign_of(document)),
            "G=2_mu=0.1 G=1_mu=0.1<G=2_mu=0.1 G=0.5_mu=0.1<G=1_mu=0.1 "
            "G=2_mu=1 G=1_mu=1<G=2_mu=1 G=0.5_mu=1<G=1_mu=1");
}

TEST(StartFrom, ExcludedCasesStartNobody) {
  json document = chained();
  document["sweep"]["exclude"] = {{{"G", 1}}};
  EXPECT_EQ(starts(campaign_of(document)),
            "G=2_mu=0.1<precursor G=0.5_mu=0.1<G=2_mu=0.1 G=2_mu=1<precursor G=0.5_mu=1<G=2_mu=1");
}

TEST(StartFrom, EqualPointsAreOneCase) {
  json document = chained();
  document["sweep"]["list"] = {{{"G", 1.0}, {"viscosity_ratio", 1}}};
  EXPECT_EQ(labels(campaign_of(document)), labels(campaign_of(chained())));
}

/// What is derived does not tear a line, and makes no precursor that nobody starts from.
TEST(StartFrom, GoesAlongReynoldsNumbersWithOnePrecursor) {
  json document = elastic_campaign();
  document["sweep"] = json::parse(R"({"grid": {"reynolds": [1000, 2000]}})");
  document["physics"]["solid"] = {{"G", 1}};
  document["derive"] = {{"viscosity_ratio", "reynolds / 1000"}};
  document["start_from"] = {{"nearest", "reynolds"}};
  const Campaign campaign = campaign_of(document);
  ASSERT_EQ(campaign.cases.size(), 3U);
  EXPECT_EQ(campaign.cases[0].definition.physics.reynolds, 2000);
  EXPECT_EQ(campaign.cases[2].precursor_id, campaign.cases[1].definition.id);
}

TEST(StartFrom, RefusesWhatCannotBe) {
  const auto with = [](const char* change) {
    json document = chained();
    document.merge_patch(json::parse(change));
    return document;
  };
  const std::pair<json, const char*> refusals[] = {
      {with(R"({"start_from": {"nearest": "ny_solid"}})"), "/start_from/nearest: \"ny_solid\""},
      {with(R"({"start_from": {"first": "softest"}})"), "/start_from/first: \"softest\""},
      {with(R"({"start_from": {"nearst": "G"}})"), "/start_from/nearst: unknown key"},
      {with(R"({"start_from": {"nearest": "mooney_share"}})"),
       "/start_from/nearest: \"mooney_share\"; has no effect: no two cases differ in it alone"},
      {with(R"({"until": {"re_tau_ci95": 2}})"), "/until: {\"re_tau_ci95\":2}; not together with start_from"},
      {with(R"({"derive": {"ny_solid": "round(8 * G) + 12"}, "physics": {"grid": {"ny_solid": null}}})"),
       "/start_from: grid/ny_solid: 20; must be that of the case that it starts from, 28"},
      {json::parse(R"({"format": 1, "name": "waves", "run": {"end_time": 1}, "start_from": {"nearest": "G"},
        "physics": {"flow": "cavity", "grid": {"nx": 32, "ny_fluid": 32, "nz": 1, "stretching": 0}}})"),
       "/start_from: given; the cases of flow \"cavity\" start by themselves"}};
  for (const auto& [document, expected] : refusals)
    EXPECT_NE(complaint_about(document).find(expected), std::string::npos) << expected << "\n"
                                                                           << complaint_about(document);
}

}  // namespace
}  // namespace softwall::campaign
