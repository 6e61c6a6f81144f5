#include "campaign/core/label.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace softwall::campaign {
namespace {

TEST(Label, ShowsTheParameters) {
  EXPECT_EQ(label_of({{"G", 0.5}, {"viscosity_ratio", 10}}), "G=0.5_mu=10");
  EXPECT_EQ(label_of({{"G", 1.0}, {"weno", "js"}}), "G=1_weno=js");
  EXPECT_EQ(label_of({{"min_eigenvalue", 1e-7}}), "min_eigenvalue=1e-07");
  EXPECT_EQ(label_of({{"G", 1e20}}), "G=1e20");
  EXPECT_EQ(label_of({{"G", 1e-20}}), "G=1e-20");
  EXPECT_EQ(label_of({{"G", 0.1 + 0.2}}), "G=0.30000000000000004");
}

TEST(Label, IsSafeAsAFileName) {
  const std::string hostile = "a b/c\n$(x)`;'\"*?~\\|<>\033%:&";
  EXPECT_EQ(safe_label(hostile), "a-b-c---x-" + std::string(hostile.size() - 10, '-'));
  EXPECT_EQ(safe_label(""), "x");
  EXPECT_EQ(safe_label(".."), "x..");
  EXPECT_EQ(safe_label("../../etc"), "x..-..-etc");
  EXPECT_EQ(safe_label("-rf"), "x-rf");
  EXPECT_EQ(safe_label("\xC3\xA4"), "x--");
  EXPECT_EQ(safe_label("G=1_mu=0.1"), "G=1_mu=0.1");
}

TEST(Label, DirectoriesAreToldApartByTheId) {
  EXPECT_EQ(case_directory("G=1", "0123456789abcdef"), "cases/G=1-01234567");
  EXPECT_EQ(label_in_directory("cases/G=1-01234567", "0123456789abcdef"), "G=1");
}

Campaign labelled(const std::vector<std::string>& labels) {
  Campaign campaign;
  for (const std::string& label : labels) {
    CampaignCase one;
    one.definition.label = label;
    one.definition.id = std::to_string(10000000 + campaign.cases.size()) + "abcdefgh";
    campaign.cases.push_back(one);
  }
  return campaign;
}

TEST(Label, OfSeveralCasesAreDistinct) {
  Campaign campaign =
      labelled({"a", "b/", "b-", "c", std::string(90, 'd') + "1", std::string(90, 'd') + "2"});
  make_labels_distinct(campaign);
  std::set<std::string> labels, directories;
  for (const CampaignCase& one : campaign.cases) {
    const std::string& label = one.definition.label;
    labels.insert(label);
    directories.insert(one.directory);
    EXPECT_LE(label.size(), 80U);
    EXPECT_EQ(label, safe_label(label));
    EXPECT_EQ(label_in_directory(one.directory, one.definition.id), label);
  }
  EXPECT_EQ(labels.size(), campaign.cases.size());
  EXPECT_EQ(directories.size(), campaign.cases.size());
  EXPECT_EQ(campaign.cases[0].definition.label, "a");
  EXPECT_EQ(campaign.cases[1].definition.label, "b--10000001");
  EXPECT_EQ(campaign.cases[5].definition.label, std::string(71, 'd') + "-10000005");
}

TEST(Label, StaysWhereACaseHasRunUnderIt) {
  Campaign campaign = labelled({"G=1", "G=1", "G=2"});
  campaign.cases[1].directory = "cases/G=1-10000001";
  make_labels_distinct(campaign, {campaign.cases[1].definition.id});
  EXPECT_EQ(campaign.cases[0].definition.label, "G=1-10000000");
  EXPECT_EQ(campaign.cases[1].definition.label, "G=1");
  EXPECT_EQ(campaign.cases[1].directory, "cases/G=1-10000001");
  EXPECT_EQ(campaign.cases[2].directory, "cases/G=2-10000002");
}

}  // namespace
}  // namespace softwall::campaign
