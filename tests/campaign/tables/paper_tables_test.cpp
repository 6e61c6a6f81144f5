#include "campaign/tables/paper_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <regex>
#include <sstream>

#include "campaign/tables/closing_table.hpp"
#include "campaign/tables/comparison_rows.hpp"
#include "campaign/tables/latex_tables.hpp"
#include "campaign/tables/measured_cases.hpp"
#include "campaign/tables/paper_values.hpp"
#include "campaign/tables/reading_fit.hpp"
#include "tests/campaign/store/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign::tests {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(PaperValues, AreTheSevenCasesWithTheirPrintedDigits) {
  const std::vector<PaperCase> cases = paper_cases();
  ASSERT_EQ(cases.size(), 7U);
  EXPECT_EQ(cases[0].name, "Reference");
  EXPECT_FALSE(cases[0].g_table.has_value());
  EXPECT_EQ(cases[0].printed.at("y_max"), "0.000");
  EXPECT_EQ(cases[0].printed.at("d"), "");
  EXPECT_EQ(cases[4].printed.at("re_tau"), "307.0");
  EXPECT_EQ(cases[4].printed.at("k_plus_dk"), "0.20");
  for (std::size_t i = 1; i < cases.size(); ++i) EXPECT_EQ(cases[i].g_table, 2.0 * cases[i].g_text.value());
}

TEST(PaperValues, HaveAColumnForEveryMeasuredQuantity) {
  for (const PaperCase& paper : paper_cases()) {
    EXPECT_EQ(paper.printed.size(), analysis::kMeasuredMembers.size());
    for (const auto& [name, member] : analysis::kMeasuredMembers)
      EXPECT_TRUE(paper.printed.contains(std::string(name)));
  }
}

TEST(PaperValues, AWrongLineIsNamed) {
  EXPECT_THROW((void)parse_paper_cases("case,G_table\nx,1,2\n"), std::runtime_error);
  EXPECT_THROW((void)parse_paper_cases("case,G_table\nx,one\n"), std::runtime_error);
}

TEST(MeasuredText, ShowsTheDigitsThatTheIntervalSupports) {
  EXPECT_EQ(measured_text({240.512, 3.21}, 1), "240.5 +- 3.2");
  EXPECT_EQ(measured_text({240.512, 32.1}, 1), "241 +- 32");
  EXPECT_EQ(measured_text({0.12034, 0.0123}, 3), "0.120 +- 0.012");
  EXPECT_EQ(measured_text({1.2, 1e-9}, 3), "1.2 +- 1e-09");
  EXPECT_EQ(measured_text({0.01234, 0.00038}, 4), "0.0123 +- 0.0004");
  EXPECT_EQ(measured_text({-123456.789, 0.01}, 1), "-1.23e+05 +- 0.01");
  EXPECT_EQ(measured_text({240.512, std::nullopt}, 1), "240.5 (*)");
  EXPECT_EQ(measured_text({std::nullopt, std::nullopt}, 1), "-");
}

TEST(MeasuredText, WhatIsNotZeroDoesNotReadAsZero) {
  EXPECT_EQ(measured_text({9.23e-4, 3.8e-5}, 4), "(923 +- 38)e-6");
  EXPECT_EQ(measured_text({2.013e-4, 6.3e-6}, 4), "(2013 +- 63)e-7");
  EXPECT_EQ(measured_text({-2.013e-4, 6.3e-6}, 4), "(-2013 +- 63)e-7");
  EXPECT_EQ(measured_text({3.21e-5, std::nullopt}, 4), "3.21e-05 (*)");
  EXPECT_EQ(measured_text({0.0, std::nullopt}, 4), "0.0000 (*)");
  EXPECT_EQ(measured_text({0.5, 0.0}, 3), "0.5000 +- 0.0000");
}

class PaperTablesTest : public ::testing::Test {
 protected:
  void SetUp() override { store.record_campaign(campaign); }
  void measure(double g, double viscosity_ratio, double re_tau) {
    const std::string& id = case_with(campaign, g, viscosity_ratio).definition.id;
    analysis::DerivedQuantities derived;
    derived.re_tau = {re_tau, 2.0};
    derived.window_start = 100.0;
    derived.window_end = 150.0;
    derived.note = "a note about it";
    store.record_result(id, derived, "");
    store.set_state(id, CaseState::kFinished, "");
  }
  std::string page() {
    std::ostringstream out;
    write_paper_tables(out, store.connection());
    return out.str();
  }
  std::string under(const std::string& reading) {
    const std::string text = page();
    const auto begin = text.find("READING \"" + reading + "\"");
    return text.substr(begin,
                       std::min(text.find("READING", begin + 1), text.find("HOW WELL", begin)) - begin);
  }
  test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  Campaign campaign = paper_campaign();
};

TEST_F(PaperTablesTest, PutsACaseBesideTheRowOfEitherReading) {
  measure(1.0, 1.0, 241.25);
  EXPECT_THAT(under("TABLE"), ContainsRegex("G3 +G=1 +mu=1 +193.0 +240.5 +1.23 +-0.206\n"
                                            " +G=1_mu=1 +- +241.2 \\+- 2.0"));
  EXPECT_THAT(under("TEXT"), ContainsRegex("G2 +G=1 +mu=1 +182.1 +203.3 +1.19 +-0.076\n"
                                           " +G=1_mu=1 +- +241.2 \\+- 2.0"));
}

TEST_F(PaperTablesTest, DistinguishesTheViscosityRatios) {
  measure(1.0, 10.0, 226.25);
  EXPECT_THAT(under("TABLE"), ContainsRegex("mu_s_high +G=1 +mu=10 [^\n]*\n +G=1_mu=10 +- +226.2 \\+- 2.0"));
  EXPECT_THAT(under("TEXT"), Not(HasSubstr("226.2")));  // there the paper has 10 with G = 0.5 only
}

TEST_F(PaperTablesTest, SaysWhatIsMissingAndWhatIsNotFinished) {
  measure(1.0, 1.0, 241.25);
  EXPECT_THAT(under("TEXT"), ContainsRegex("G4 +G=0.25 +mu=1 [^\n]*\n +\\(not in this campaign\\)"));
  EXPECT_THAT(page(), HasSubstr("G=4_mu=1 (new)"));
  EXPECT_THAT(page(),
              ContainsRegex("G=1_mu=1: finished, grid 48x64\\+16x48, mean over t = 100 to 150 of 50 h/U_b"));
  EXPECT_THAT(page(), HasSubstr("a note about it"));
  EXPECT_THAT(page(), HasSubstr("nothing measured yet"));
}

TEST_F(PaperTablesTest, AnotherReynoldsNumberOrLayerIsNoCounterpart) {
  for (const char* parameter : {"reynolds", "layer"}) {
    nlohmann::json document = elastic_campaign();
    if (parameter == std::string("reynolds")) document["physics"]["reynolds"] = 3000;
    if (parameter == std::string("layer")) {
      document["physics"]["domain"]["layer_height"] = 0.25;
      document["physics"]["grid"]["ny_solid"] = 8;
    }
    document["sweep"] = {{"list", {{{"G", 1}, {"viscosity_ratio", 1}}}}};
    store.record_campaign(campaign_of(document));
    EXPECT_THAT(page(), HasSubstr("no counterpart in the paper")) << parameter;
    EXPECT_THAT(page(), Not(ContainsRegex("\n +G=1_mu=1 "))) << parameter;
  }
}

TEST_F(PaperTablesTest, AnotherFlowIsNoCounterpart) {
  const nlohmann::json wave = nlohmann::json::parse(R"({
    "format": 1, "name": "a wave at the interface of the paper's layer",
    "physics": {"flow": "interface_wave", "grid": {"nx": 32, "ny_fluid": 32, "ny_solid": 8, "nz": 1},
                "solid": {"G": 1}, "wave": {"decay": 0.0543952160378, "frequency": 3.09964567747}},
    "run": {"end_time": 4}})");
  store.record_campaign(campaign_of(wave));
  EXPECT_THAT(page(), HasSubstr("has no case that the paper's tables show"));
  EXPECT_THAT(page(), HasSubstr("no counterpart in the paper"));
}

TEST_F(PaperTablesTest, WithoutAnyCounterpartThereAreNoTables) {
  nlohmann::json document = elastic_campaign();
  document["physics"]["reynolds"] = 3000;
  store.record_campaign(campaign_of(document));
  EXPECT_THAT(page(), HasSubstr("has no case that the paper's tables show"));
  EXPECT_THAT(page(), HasSubstr("HOW EACH CASE"));
  EXPECT_THAT(page(), Not(HasSubstr("READING")));
}

TEST_F(PaperTablesTest, ALongLabelIsShortened) {
  CampaignCase named = case_with(campaign, 1.0, 1.0);
  named.definition.label = std::string(60, 'x');
  store.record_campaign(campaign_with(named));
  EXPECT_THAT(under("TABLE"), ContainsRegex("\n  x+\\.\\.\\. \\(new\\) "));
}

TEST_F(PaperTablesTest, AreRowsForOtherPrograms) {
  measure(1.0, 1.0, 241.25);
  const ResultTable table = comparison_rows(store.connection());
  const auto cell = [&](const std::vector<Cell>& row, const std::string& column) {
    const auto at = std::ranges::find(table.columns, column) - table.columns.begin();
    return row.at(static_cast<std::size_t>(at));
  };
  std::map<std::string, double> paper;
  for (const auto& row : table.rows) {
    ASSERT_EQ(row.size(), table.columns.size());
    if (cell(row, "label") != Cell(std::string("G=1_mu=1"))) continue;
    EXPECT_EQ(cell(row, "re_tau"), Cell(241.25));
    EXPECT_EQ(cell(row, "re_tau_ci95"), Cell(2.0));
    EXPECT_EQ(cell(row, "re_tau_w"), Cell(std::monostate{}));
    EXPECT_EQ(cell(row, "window_start"), Cell(100.0));
    paper[std::get<std::string>(cell(row, "reading"))] = std::get<double>(cell(row, "re_tau_paper"));
  }
  EXPECT_EQ(paper, (std::map<std::string, double>{{"table", 240.5}, {"text", 203.3}, {"half", 180.8}}));
}

TEST_F(PaperTablesTest, SaysHowWellEachReadingFits) {
  // Of the row with 203.3 each reading has a case; of that with 240.5 the table's and the text's, of the last
  // and of the first one of them.
  measure(1.0, 1.0, 203.3);
  measure(2.0, 1.0, 230.0);
  measure(0.5, 1.0, 220.0);
  EXPECT_THAT(
      page(),
      ContainsRegex("    text: 0\\.[0-9]*, 3 values of 3 rows; over shared rows 0, 1 value of 1 row, the "
                    "least\n"));
  EXPECT_THAT(
      page(),
      ContainsRegex("    table: 0\\.[0-9]*, 3 values of 3 rows; over shared rows 0\\.2[0-9]*, 1 value of 1 "
                    "row\n"));
  EXPECT_EQ(best_of(reading_fits(measured_cases(store.connection())))->reading->name, std::string("text"));
}

TEST_F(PaperTablesTest, SaysNothingOfAReadingWithoutResults) {
  EXPECT_THAT(page(), HasSubstr("    half: no case with results\n"));
  EXPECT_THAT(page(), HasSubstr("nothing compares them"));
  measure(1.0, 1.0, 203.3);  // under each reading beside another row
  EXPECT_THAT(page(), HasSubstr("    text: 0, 1 value of 1 row\n"));
  EXPECT_THAT(page(), HasSubstr("nothing compares them"));
  EXPECT_EQ(best_of(reading_fits(measured_cases(store.connection()))), nullptr);
}

TEST_F(PaperTablesTest, CaseWithoutCounterpartIsOneRow) {
  nlohmann::json document = elastic_campaign();
  document["physics"]["reynolds"] = 3000;
  store.record_campaign(campaign_of(document));
  EXPECT_EQ(comparison_rows(store.connection()).rows.size(), 5U);
}

TEST_F(PaperTablesTest, AreLatexThatNothingBreaks) {
  measure(1.0, 1.0, 241.25);
  std::ostringstream out;
  write_latex_tables(out, store.connection());
  EXPECT_THAT(out.str(), HasSubstr("  \\quad G=1\\_mu=1 & -- & $241.2 \\pm 2.0$ & -- & -- \\\\\n"));
  EXPECT_THAT(out.str(), HasSubstr(" (paper) & $193.0$ & $240.5$ & $1.23$ & $-0.206$ \\\\\n"));
  const std::regex unescaped(R"((^|[^\\$^])_)");
  std::istringstream lines(out.str());
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  \\quad")) {
      EXPECT_FALSE(std::regex_search(line.substr(0, line.find('&')), unescaped)) << line;
    }
  }
}

TEST_F(PaperTablesTest, SmallDeformationsHaveIntervalsInEveryTable) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  analysis::DerivedQuantities derived;
  derived.delta_max = {9.23e-4, 3.8e-5};
  derived.delta_rms = {2.013e-4, kNone};
  derived.d = {3.2e-9, kNone};
  store.record_result(case_with(campaign, 1.0, 1.0).definition.id, derived, "");
  std::ostringstream latex, closing;
  write_latex_tables(latex, store.connection());
  write_closing_table(closing, store.connection());
  EXPECT_THAT(latex.str(), HasSubstr("& $3.2\\cdot10^{-9}{}^{*}$ & -- & -- & $(923 \\pm 38)\\cdot10^{-6}$ & "
                                     "$0.0002{}^{*}$ \\\\\n"));
  EXPECT_THAT(closing.str(), HasSubstr("  (923 +- 38)e-6  0.0002 (*)\n"));
  EXPECT_THAT(page(), HasSubstr("  (923 +- 38)e-6  0.0002 (*)\n"));
}

TEST_F(PaperTablesTest, ClosingTableHasIntervalsAndUnits) {
  measure(1.0, 1.0, 241.25);
  std::ostringstream out;
  write_closing_table(out, store.connection());
  EXPECT_THAT(out.str(), HasSubstr("t [h/U_b]"));
  EXPECT_THAT(out.str(), HasSubstr("u_max [U_b]"));
  EXPECT_THAT(out.str(), ContainsRegex("G=1_mu=1 +finished +100-150 +- +241.2 \\+- 2.0"));
  EXPECT_THAT(out.str(), ContainsRegex("G=4_mu=1 +new +- "));
}

TEST_F(PaperTablesTest, ClosingTableOfAHugeCampaignSaysHowMuchItLeftOut) {
  for (int number = 0; number < 150; ++number) {
    CampaignCase more = campaign.cases.front();
    more.definition.id = "more" + std::to_string(number);
    more.definition.label = more.definition.id;
    more.directory = "cases/" + more.definition.id;
    campaign.cases.push_back(more);
  }
  store.record_campaign(campaign);
  std::ostringstream out;
  write_closing_table(out, store.connection());
  const std::string text = out.str();
  EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 100 + 2);
  EXPECT_THAT(text, HasSubstr("and " + std::to_string(campaign.cases.size() - 100) + " cases more"));
}

TEST_F(PaperTablesTest, FitsThePageAndHasNoTrailingBlanks) {
  for (const CampaignCase& each : campaign.cases) {
    analysis::DerivedQuantities derived = result_made_of(-123.456);
    derived.re_tau_w = {1e9, 0.001};
    derived.note = std::string(20, 'x') + " " + std::string(90, 'y') + " " + std::string(90, 'z');
    store.record_result(each.definition.id, derived, "");
  }
  std::istringstream lines(page());
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 120U) << line;
    EXPECT_FALSE(line.ends_with(' ')) << line;
  }
}

}  // namespace
}  // namespace softwall::campaign::tests
