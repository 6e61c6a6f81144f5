#pragma once

#include <gtest/gtest.h>

#include "campaign/observe/observe.hpp"
#include "tests/campaign/store/examples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace softwall::campaign::tests {

/// A store that has recorded a campaign of which nothing has run, and one of its elastic cases.
class RecordedCampaign : public ::testing::Test {
 protected:
  RecordedCampaign() { store.record_campaign(campaign); }

  test::TemporaryFolder folder;
  Store store = Store::open(folder.path(), OpenMode::kCreate);
  Campaign campaign = paper_campaign();
  CampaignCase& one = campaign.cases.back();
  RunFiles run = run_files(folder.path(), one);
};

}  // namespace softwall::campaign::tests
