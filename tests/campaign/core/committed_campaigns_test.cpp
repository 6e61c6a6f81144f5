#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "campaign/core/campaign_file.hpp"
#include "campaign/core/estimate.hpp"

/// The campaign files of the project in runs/ are accepted and mean the paper's cases.
namespace softwall::campaign {
namespace {

std::vector<std::filesystem::path> committed_campaigns() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"quickstart", "rosti-brandt-2017"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(SOFTWALL_RUNS_FOLDER) / folder))
      if (entry.path().filename() == "campaign.json") files.push_back(entry.path());
  return files;
}

TEST(CommittedCampaigns, AreThere) { EXPECT_GE(committed_campaigns().size(), 3U); }

TEST(CommittedCampaigns, HaveThePapersSevenCases) {
  const std::set<std::pair<double, double>> wanted{{0.5, 1}, {1, 1}, {2, 1}, {4, 1}, {1, 0.1}, {1, 10}};
  for (const auto& file : committed_campaigns()) {
    const auto folder = file.parent_path().filename();
    if (folder == "workstation" || folder == "quickstart")
      continue;  // walls of their own: contracts/test_campaigns.py
    const Campaign campaign = read_campaign(file);
    std::set<std::pair<double, double>> found;
    for (const auto& c : campaign.cases)
      if (c.definition.physics.solid)
        found.emplace(c.definition.physics.solid->G, c.definition.physics.solid->viscosity_ratio);
    EXPECT_EQ(found, wanted) << file;
    EXPECT_EQ(campaign.cases.size(), 7U) << file;
    EXPECT_TRUE(campaign.cases.front().is_precursor) << file;
    for (const auto& c : campaign.cases) EXPECT_GT(estimate(c.definition, 100.0).core_hours, 0.0) << file;
  }
}

}  // namespace
}  // namespace softwall::campaign
