#include "campaign/tables/grid_convergence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "campaign/tables/paper_tables.hpp"
#include "campaign/tables/reading_fit.hpp"
#include "tests/campaign/store/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign::tests {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

MeasuredCase on_grid(const std::string& label, int side, const MeasuredValue& re_tau) {
  MeasuredCase one;
  one.label = label;
  one.grid = std::to_string(side) + "x" + std::to_string(side) + "x" + std::to_string(side);
  one.sides = {side, side, side};
  one.but_for_the_grid = "{}";
  if (re_tau.value) one.values["re_tau"] = re_tau;
  return one;
}

TEST(GridConvergence, ExtrapolatesAnErrorOfSecondOrderToItsLimit) {
  const auto value_on = [](int side) { return 200 + 3.0e4 / (side * side); };
  const MeasuredCase coarser = on_grid("coarse", 100, {value_on(100), 0.0});
  const MeasuredCase finer = on_grid("fine", 150, {value_on(150), 0.0});
  const MeasuredValue limit = extrapolated(coarser, finer, "re_tau");
  EXPECT_NEAR(limit.value.value(), 200, 1e-10);
  // An error of first order would have its limit at value(150) - 2 (value(100) - value(150)).
  const double first_order = value_on(150) - 2 * (value_on(100) - value_on(150));
  EXPECT_NEAR(limit.ci95.value(), 200 - first_order, 1e-10);
}

TEST(GridConvergence, TheIntervalsOfBothGridsWidenTheLimit) {
  const MeasuredCase coarser = on_grid("coarse", 100, {200, 5}), finer = on_grid("fine", 150, {200, 2});
  // The limit is 1.8 finer - 0.8 coarser.
  EXPECT_NEAR(extrapolated(coarser, finer, "re_tau").ci95.value(), std::hypot(1.8 * 2, 0.8 * 5), 1e-12);
  const MeasuredCase without = on_grid("fine", 150, {200, std::nullopt});
  EXPECT_TRUE(extrapolated(coarser, without, "re_tau").value.has_value());
  EXPECT_FALSE(extrapolated(coarser, without, "re_tau").ci95.has_value());
}

/// Of 1 - before / now, the two being independent.
TEST(GridConvergence, AChangeIsAsUncertainAsTheValuesThatItComesFrom) {
  const MeasuredCase coarser = on_grid("coarse", 100, {200, 5}), finer = on_grid("fine", 150, {210, 2});
  EXPECT_NEAR(change(coarser, finer, "re_tau").ci95.value(), 200.0 / 210 * std::hypot(5.0 / 200, 2.0 / 210),
              1e-12);
  const MeasuredCase without = on_grid("fine", 150, {210, std::nullopt});
  EXPECT_FALSE(change(coarser, without, "re_tau").ci95.has_value());
  EXPECT_TRUE(change(coarser, without, "re_tau").value.has_value());
}

TEST(GridConvergence, GridsThatAreNearlyTheSameSayNothing) {
  const MeasuredCase coarser = on_grid("coarse", 100, {200, 5}), finer = on_grid("fine", 120, {210, 2});
  EXPECT_FALSE(extrapolated(coarser, finer, "re_tau").value.has_value());
  EXPECT_NEAR(change(coarser, finer, "re_tau").value.value(), 10.0 / 210, 1e-15);
  EXPECT_FALSE(change(coarser, finer, "delta_max").value.has_value());
}

TEST(GridConvergence, ADirectionThatIsNotRefinedSaysNothing) {
  MeasuredCase coarser = on_grid("coarse", 100, {200, 5}), finer = on_grid("fine", 200, {210, 2});
  finer.sides[0] = 100;
  EXPECT_FALSE(extrapolated(coarser, finer, "re_tau").value.has_value());
}

TEST(GridConvergence, OnlyCasesThatDifferInNothingElseAreCompared) {
  MeasuredCase other = on_grid("other wall", 150, {300, 1});
  other.but_for_the_grid = R"({"G": 1})";
  const std::vector<MeasuredCase> cases = {on_grid("fine", 150, {210, 1}), on_grid("coarse", 100, {200, 1}),
                                           other, on_grid("finest, not yet run", 200, {})};
  const auto groups = cases_on_grids(cases);
  ASSERT_EQ(groups.size(), 1U);
  ASSERT_EQ(groups[0].size(), 2U);
  EXPECT_EQ(groups[0][0]->label, "coarse");
  EXPECT_EQ(groups[0][1]->label, "fine");
  const auto finest = finest_of_each(cases);
  ASSERT_EQ(finest.size(), 2U);
  EXPECT_EQ(finest[0].label, "fine");
  EXPECT_EQ(finest[1].label, "other wall");
}

/// A campaign of two walls on two grids.
class TwoGridsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    nlohmann::json document = elastic_campaign();
    document["sweep"] = nlohmann::json::parse(R"({"list": [
      {"G": 1, "nx": 48, "ny_fluid": 32, "ny_solid": 8, "nz": 48}, {"G": 1, "nx": 72, "ny_fluid": 48, "ny_solid": 12, "nz": 72},
      {"G": 2, "nx": 48, "ny_fluid": 32, "ny_solid": 8, "nz": 48}]})");
    campaign = campaign_of(document);
    store.record_campaign(campaign);
  }
  void measure(const std::string& label, double re_tau) {
    analysis::DerivedQuantities derived;
    derived.re_tau = {re_tau, 2.0};
    for (const CampaignCase& each : campaign.cases)
      if (each.definition.label == label) store.record_result(each.definition.id, derived, "");
  }
  std::string page() {
    std::ostringstream out;
    write_paper_tables(out, store.connection());
    return out.str();
  }
  const std::string coarse = "nx=48_ny_fluid=32_ny_solid=8_nz=48_G=1",
                    fine = "nx=72_ny_fluid=48_ny_solid=12_nz=72_G=1",
                    other = "nx=48_ny_fluid=32_ny_solid=8_nz=48_G=2";
  test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  Campaign campaign;
};

TEST_F(TwoGridsTest, ThePageShowsTheChangeFromGridToGrid) {
  measure(other, 180);
  measure(coarse, 200);
  EXPECT_THAT(page(), Not(HasSubstr("WHAT THE GRID CHANGES")));
  measure(fine, 205);
  EXPECT_THAT(page(), ContainsRegex("\nG=1 +48x32\\+8x48 +200.0 \\+- 2.0 +-\n"
                                    " +72x48\\+12x72 +205.0 \\+- 2.0 +\\+2.4 \\+- 1.4 +- +-\n"
                                    " +extrapolated +209.0 \\+- 7.2 +-\n"));
}

TEST_F(TwoGridsTest, HowAFlowIsSampledIsNoPartOfItsPhysics) {
  nlohmann::json document = elastic_campaign();
  document["sweep"] = nlohmann::json::parse(R"({"list": [
    {"G": 1, "nx": 48, "ny_fluid": 32, "ny_solid": 8, "nz": 48, "interval_steps": 7},
    {"G": 1, "nx": 72, "ny_fluid": 48, "ny_solid": 12, "nz": 72, "interval_steps": 5}]})");
  campaign = campaign_of(document);
  store.record_campaign(campaign);
  for (const CampaignCase& each : campaign.cases) measure(each.definition.label, 200);
  EXPECT_THAT(page(), ContainsRegex("WHAT THE GRID CHANGES(.|\n)*\nelastic wall +48x32\\+8x48 "));
}

TEST_F(TwoGridsTest, AReadingIsJudgedByTheFinestGrid) {
  measure(coarse, 300);
  measure(fine, 203.3);  // printed for this G as the text reads
  EXPECT_THAT(page(), HasSubstr("    text: 0, 1 value of 1 row\n"));
}

}  // namespace
}  // namespace softwall::campaign::tests
