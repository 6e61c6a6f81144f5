#include "campaign/core/until.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/campaign/core/examples.hpp"

namespace softwall::campaign {
namespace {

using nlohmann::json;
using tests::campaign_of;
using tests::complaint_about;
using tests::elastic_campaign;

json until(const std::string& text) {
  json document = elastic_campaign();
  document["until"] = json::parse(text);
  return document;
}

auto results(double re_tau, std::optional<double> ci95) {
  return [=](const std::string& quantity) {
    return quantity == "re_tau" ? UncertainResult{re_tau, ci95} : UncertainResult{-0.1, 0.001};
  };
}

TEST(Until, IsOfTheCasesAndNotOfThePrecursor) {
  const auto campaign = campaign_of(until(R"({"re_tau_ci95": "2 %", "delta_max_ci95": 0.001})"));
  EXPECT_TRUE(campaign.cases.front().until.empty());
  ASSERT_EQ(campaign.cases.back().until.size(), 2U);
  EXPECT_EQ(describe(campaign.cases.back().until), "delta_max within 0.001, re_tau within 2 %");
}

TEST(Until, IsToldAsItWasWritten) {
  for (const std::string share : {"0.9 %", "1.7 %", "3.3 %", "10 %", "0.001 %"}) {
    const auto campaign = campaign_of(until(R"({"re_tau_ci95": ")" + share + R"("})"));
    EXPECT_EQ(describe(campaign.cases.back().until), "re_tau within " + share);
  }
}

TEST(Until, IsNoPartOfACase) {
  const auto with = campaign_of(until(R"({"re_tau_ci95": 2})")), without = campaign_of(elastic_campaign());
  for (std::size_t i = 0; i < with.cases.size(); ++i) {
    EXPECT_EQ(with.cases[i].definition.id, without.cases[i].definition.id);
    EXPECT_EQ(with.cases[i].directory, without.cases[i].directory);
  }
}

TEST(Until, IsMetByAHalfWidthOrAShare) {
  const auto half_width = interval_targets(json::parse(R"({"re_tau_ci95": 2})"));
  EXPECT_TRUE(are_met(half_width, results(150, 2.0)));
  EXPECT_FALSE(are_met(half_width, results(150, 2.1)));
  const auto share = interval_targets(json::parse(R"({"re_tau_ci95": "2%"})"));
  EXPECT_TRUE(are_met(share, results(150, 3.0)));
  EXPECT_TRUE(are_met(share, results(-150, 3.0))) << "of the size of the value";
  EXPECT_FALSE(are_met(share, results(150, 3.1)));
}

TEST(Until, NeedsEveryIntervalAndAValue) {
  const auto both = interval_targets(json::parse(R"({"re_tau_ci95": 2, "y_max_ci95": "5 %"})"));
  EXPECT_TRUE(are_met(both, results(150, 1)));
  EXPECT_FALSE(are_met(both, results(150, 3)));
  EXPECT_FALSE(are_met(both, results(150, std::nullopt))) << "too few blocks give no interval";
  EXPECT_FALSE(are_met(both, results(std::nan(""), 1)));
  EXPECT_FALSE(are_met({}, results(150, 1)));
}

TEST(Until, RefusesWhatCanNeverBeMet) {
  const std::pair<const char*, const char*> refusals[] = {
      {R"({"re_tau": 2})", "/until/re_tau: unknown key"},
      {R"({"re_tav_ci95": 2})", "/until/re_tav_ci95: unknown key; did you mean \"re_tau_ci95\"?"},
      {R"({"re_tau_ci95": 0})", "/until/re_tau_ci95: 0; must be "},
      {R"({"re_tau_ci95": -1})", "/until/re_tau_ci95: -1; must be"},
      {R"({"re_tau_ci95": "2"})", "/until/re_tau_ci95: \"2\"; must be"},
      {R"({"re_tau_ci95": "two %"})", "/until/re_tau_ci95: \"two %\"; must be"},
      {R"({"re_tau_ci95": "0 %"})", "/until/re_tau_ci95: \"0 %\"; must be"},
      {R"({"re_tau_ci95": "inf %"})", "/until/re_tau_ci95: \"inf %\"; must be"},
      {R"({"re_tau_ci95": true})", "/until/re_tau_ci95: true; must be"},
      {R"({"re_tau_ci95": "%"})", "/until/re_tau_ci95: \"%\"; must be"},
      {R"([])", "/until: "},
  };
  for (const auto& [text, said] : refusals)
    EXPECT_NE(complaint_about(until(text)).find(said), std::string::npos) << text << "\n"
                                                                          << complaint_about(until(text));
}

TEST(Until, RefusesWhatTheFlowDoesNotHave) {
  json rigid = until(R"({"delta_max_ci95": 0.1})");
  rigid.erase("precursor");
  rigid.erase("sweep");
  rigid["physics"]["flow"] = "rigid_channel";
  rigid["physics"]["grid"].erase("ny_solid");
  EXPECT_NE(complaint_about(rigid).find(
                "/until/delta_max_ci95: 0.1; has no effect: a rigid channel has no delta_max"),
            std::string::npos)
      << complaint_about(rigid);
  rigid["until"] = {{"re_tau_ci95", 1}};
  EXPECT_EQ(complaint_about(rigid), "");
  rigid["physics"]["flow"] = "cavity";
  EXPECT_NE(complaint_about(rigid).find("has no effect: the results of a cavity have no intervals"),
            std::string::npos);
}

}  // namespace
}  // namespace softwall::campaign
