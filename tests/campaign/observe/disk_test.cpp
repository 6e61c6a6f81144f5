#include "campaign/observe/disk.hpp"

#include <gtest/gtest.h>

#include "tests/campaign/core/examples.hpp"

namespace softwall::campaign {
namespace {

constexpr double kRigidRows = 3 * 64 + 65,
                 kWallRows = 5 * 80 + 2 * 81;  // of a checkpoint with a reference map
constexpr double kRigidPlane = 32.0 * 48 * 8, kWallPlane = 48.0 * 48 * 8;

/// A precursor of 32 x 64 x 48 cells to t = 100, four walls of 48 x (64 + 16) x 48 cells to t = 50.
Campaign campaign_with_snapshots(double of_precursor, double of_walls) {
  auto document = tests::elastic_campaign();
  document["precursor"]["run"]["field_interval"] = of_precursor;
  document["run"]["field_interval"] = of_walls;
  return tests::campaign_of(document);
}

DiskNeed need_of(const Campaign& campaign, const Observation& of_all = {}) {
  return disk_need(campaign, std::vector<Observation>(campaign.cases.size(), of_all));
}

TEST(DiskNeed, OfANewCampaignIsAllCheckpointsAndNoSnapshots) {
  const auto need = need_of(tests::campaign_of(tests::elastic_campaign()));
  EXPECT_DOUBLE_EQ(need.checkpoint_bytes, 3 * (kRigidRows * kRigidPlane + 4 * kWallRows * kWallPlane));
  EXPECT_EQ(need.snapshots, 0);
  EXPECT_EQ(need.snapshot_bytes, 0);
}

TEST(DiskNeed, CountsTheSnapshotAtTheStartAndOneAnInterval) {
  const auto need = need_of(campaign_with_snapshots(30, 10));  // at 0, 30, 60, 90; at 0, 10 .. 50
  EXPECT_EQ(need.snapshots, 4 + 4 * 6);
  EXPECT_DOUBLE_EQ(need.snapshot_bytes, 4 * (4 * 64 * kRigidPlane) + 4 * 6 * (8 * 80 * kWallPlane));
  EXPECT_DOUBLE_EQ(need.bytes(), need.checkpoint_bytes + need.snapshot_bytes);
  EXPECT_EQ(need_of(campaign_with_snapshots(0, 0.1)).snapshots, 4 * 501);  // 0.1 is no binary number
}

TEST(DiskNeed, CountsTheMomentsOfFilms) {
  auto document = tests::elastic_campaign();
  document["run"]["plane_interval"] = 5;  // at 0, 5 .. 50: of the walls alone
  const auto need = need_of(tests::campaign_of(document));
  EXPECT_EQ(need.film_moments, 4 * 11);
  EXPECT_DOUBLE_EQ(need.film_bytes, 4 * 11 * (48.0 * 48 * 4));  // no plane is asked for: the interface
  EXPECT_DOUBLE_EQ(need.bytes(), need.checkpoint_bytes + need.film_bytes);
  document["run"]["planes"]["z"] = {0.5};  // the precursor films the same plane, at 0, 5 .. 100
  const double of_walls = 4 * 11 * (48.0 * 48 + 5 * (48 * 80)) * 4, of_precursor = 21 * (4 * (32.0 * 64)) * 4;
  EXPECT_DOUBLE_EQ(need_of(tests::campaign_of(document)).film_bytes, of_walls + of_precursor);
}

TEST(DiskNeed, IsToldInWords) {
  DiskNeed need;
  need.checkpoint_bytes = 1.2e9;
  EXPECT_EQ(words_of(need), "checkpoints 1.2 GB");
  need.snapshot_bytes = 5e7;
  need.snapshots = 1;
  EXPECT_EQ(words_of(need), "checkpoints 1.2 GB, 1 snapshot 0.05 GB");
  need.film_bytes = 2e8;
  need.film_moments = 800;
  EXPECT_EQ(words_of(need), "checkpoints 1.2 GB, 1 snapshot 0.05 GB, 800 moments of films 0.2 GB");
}

TEST(DiskNeed, OfACaseOnItsWayIsWhatIsStillToCome) {
  Observation seen;
  seen.state = CaseState::kInterrupted;
  seen.newest_checkpoint = "checkpoint";
  seen.time = 25.3;
  seen.step = 900;
  const auto need = need_of(campaign_with_snapshots(0, 10), seen);
  EXPECT_EQ(need.checkpoint_bytes, 0);
  EXPECT_EQ(need.snapshots, 4 * 3);  // 30, 40, 50
}

TEST(DiskNeed, OfAFinishedCaseIsThatOfALaterEndTime) {
  Observation seen;
  seen.state = CaseState::kFinished;
  seen.time = 40.1;
  seen.step = 1500;
  EXPECT_EQ(need_of(campaign_with_snapshots(0, 10), seen).snapshots, 4);
  seen.time = 50.2;
  EXPECT_EQ(need_of(campaign_with_snapshots(0, 10), seen).bytes(), 0);
  seen.time = 20;
  seen.early = true;  // precise enough: it does not go on
  EXPECT_EQ(need_of(campaign_with_snapshots(0, 10), seen).snapshots, 0);
}

}  // namespace
}  // namespace softwall::campaign
