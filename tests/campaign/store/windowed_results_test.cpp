#include "campaign/store/windowed_results.hpp"

#include <gtest/gtest.h>

#include "tests/campaign/store/recorded_campaign.hpp"

/// Results over another window, of cases whose statistics are there no more.
namespace softwall::campaign::tests {
namespace {

class WindowedResultsTest : public RecordedCampaign {
 protected:
  WindowedResultsTest() {
    analysis::DerivedQuantities derived = result_made_of(100);
    derived.window_asked = 10;
    store.record_result(one.definition.id, derived, "");
  }
};

TEST_F(WindowedResultsTest, AResultOverItsOwnWindowIsLeftOutAndTold) {
  const WindowedResults results = results_from(folder.path(), 20);
  EXPECT_FALSE(results.store.result_origin(one.definition.id));
  ASSERT_EQ(results.troubles.size(), 1U) << "the cases that have none have nothing to miss";
  EXPECT_TRUE(results.troubles[0].starts_with(one.definition.label + ": ")) << results.troubles[0];
}

TEST_F(WindowedResultsTest, OneOverTheWindowThatIsAskedForStays) {
  const WindowedResults results = results_from(folder.path(), 10);
  EXPECT_TRUE(results.store.result_origin(one.definition.id));
  EXPECT_TRUE(results.troubles.empty());
}

}  // namespace
}  // namespace softwall::campaign::tests
