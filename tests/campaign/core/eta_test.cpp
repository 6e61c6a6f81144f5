#include "campaign/core/eta.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "campaign/core/estimate.hpp"
#include "tests/campaign/core/examples.hpp"

namespace softwall::campaign {
namespace {

class Eta : public ::testing::Test {
 protected:
  Eta() {
    for (const CampaignCase& one : campaign_.cases) seen_.emplace_back().case_id = one.definition.id;
  }

  [[nodiscard]] double left(int cores) const { return remaining_seconds(campaign_, seen_, working_, cores); }

  /// Seconds that the case takes at the default speed, on its own number of ranks.
  [[nodiscard]] double seconds_of(std::size_t i, double reached = 0) const {
    const Case& c = campaign_.cases[i].definition;
    return estimate(c, default_ns_per_cell_step(c.physics), reached).core_hours * 3600 /
           campaign_.cases[i].ranks;
  }

  void finish(std::size_t i) {
    seen_[i].state = CaseState::kFinished;
    seen_[i].time = campaign_.cases[i].definition.run.end_time;
    seen_[i].newest_checkpoint = "its last one";
  }

  /// At t = 40, with steps of 0.1 that take 2 s each.
  static Status report_of_solver() {
    Status status;
    status.time = 40;
    status.dt = 0.1;
    status.seconds_per_step = 2;
    return status;
  }

  Campaign campaign_ = tests::campaign_of(tests::elastic_campaign());  // a precursor and four elastic cases
  std::vector<Observation> seen_;
  std::map<std::string, Status> working_;
};

TEST_F(Eta, OfANewCampaignIsThePrecursorAndThenTheRestSideBySide) {
  double elastic = 0;
  for (std::size_t i = 1; i < 5; ++i) elastic += seconds_of(i);
  EXPECT_NEAR(left(1), seconds_of(0) + elastic, 1e-6 * elastic);
  EXPECT_NEAR(left(2), seconds_of(0) + elastic / 2, 1e-6 * elastic);
}

TEST_F(Eta, TheSpeedOfOneFormulationTellsNothingOfTheOther) {
  auto document = tests::elastic_campaign();
  document["sweep"] = {{"grid", {{"formulation", {"reference_map", "transported_B"}}}}};
  document["physics"]["solid"]["G"] = 1;
  campaign_ = tests::campaign_of(document);
  std::vector<Observation> seen(campaign_.cases.size());
  const auto is_map = [](const CampaignCase& one) {
    const auto& solid = one.definition.physics.solid;
    return solid && solid->formulation == SolidFormulation::kReferenceMap;
  };
  const auto map = std::ranges::find_if(campaign_.cases, is_map);
  seen[static_cast<std::size_t>(map - campaign_.cases.begin())].seconds_per_step = 1e3;
  const MeasuredSpeed speed(campaign_, seen);
  for (const CampaignCase& one : campaign_.cases) {
    const double usual = default_ns_per_cell_step(one.definition.physics);
    const double now = speed.ns_per_cell_step(one.definition.physics);
    EXPECT_EQ(now > 100 * usual, is_map(one)) << one.definition.label << ": " << now;
    EXPECT_EQ(now == usual, !is_map(one)) << one.definition.label << ": " << now;
  }
}

TEST_F(Eta, IsNeverLessThanTheLongestCase) {
  double longest = 0;
  for (std::size_t i = 1; i < 5; ++i) longest = std::max(longest, seconds_of(i));
  EXPECT_NEAR(left(1000), seconds_of(0) + longest, 1e-6 * longest);
}

TEST_F(Eta, OfALineIsAllOfItsCasesHoweverManyCoresThereAre) {
  double line = 0;
  for (std::size_t i = 1; i < 5; ++i) {
    line += seconds_of(i);
    if (i > 1) campaign_.cases[i].precursor_id = campaign_.cases[i - 1].definition.id;
  }
  EXPECT_NEAR(left(1000), seconds_of(0) + line, 1e-6 * line);
}

TEST_F(Eta, PrecursorsShareTheCoresAsOtherCasesDo) {
  for (CampaignCase& one : campaign_.cases) one.is_precursor = true;
  double all = 0;
  for (std::size_t i = 0; i < 5; ++i) all += seconds_of(i) * campaign_.cases[i].ranks;
  EXPECT_NEAR(left(1), all, 1e-6 * all);
  EXPECT_NEAR(left(2), std::max(all / 2, seconds_of(0)), 1e-6 * all);
}

TEST_F(Eta, CountsNothingForWhatWaitsForSomebody) {
  seen_[0].attempts_without_progress = 2;  // the precursor: nothing starts without it
  EXPECT_EQ(left(1), 0);
  seen_[0].attempts_without_progress = 0;
  seen_[0].needs_person = "its checkpoints cannot be read";
  EXPECT_EQ(left(1), 0);
}

TEST_F(Eta, CountsNothingForWhatIsFinishedDivergedOrRefused) {
  finish(0);
  seen_[1].state = CaseState::kDiverged;
  seen_[2].retry_allowed = false;
  finish(3);
  EXPECT_NEAR(left(1), seconds_of(4), 1e-6);
  finish(4);
  EXPECT_EQ(left(1), 0);
}

TEST_F(Eta, CountsFromWhereACaseHasGotTo) {
  for (std::size_t i = 0; i < 4; ++i) finish(i);
  seen_[4].time = 25;  // of 50
  EXPECT_NEAR(left(1), seconds_of(4) / 2, 0.01 * seconds_of(4));
}

TEST_F(Eta, OfACaseThatHasRunIsWhatWasMeasuredOfItself) {
  Observation seen;
  seen.end_time = 10;
  EXPECT_FALSE(measured_seconds_left(campaign_.cases[1], seen));
  seen.step = 100;
  seen.time = 4;
  EXPECT_FALSE(measured_seconds_left(campaign_.cases[1], seen)) << "its speed is not known";
  seen.seconds_per_step = 2;
  EXPECT_DOUBLE_EQ(measured_seconds_left(campaign_.cases[1], seen).value(), 150 * 2.0);
  seen.time = 11;
  EXPECT_EQ(measured_seconds_left(campaign_.cases[1], seen), 0.0);
}

TEST_F(Eta, BelievesARunningSolver) {
  for (std::size_t i = 0; i < 4; ++i) finish(i);
  working_[seen_[4].case_id] = report_of_solver();
  EXPECT_NEAR(left(1), (50 - 40) / 0.1 * 2, 1e-6);
}

TEST_F(Eta, LearnsTheSpeedFromCasesOfTheSameKind) {
  const GridSpec& grid = campaign_.cases[1].definition.physics.grid;
  const double cells = double(grid.nx) * grid.ny() * grid.nz;
  seen_[1].seconds_per_step = 1e-6 * cells;  // 1000 ns a cell on one rank
  const MeasuredSpeed measured(campaign_, seen_);
  const auto speed = [&](std::size_t i) {
    return measured.ns_per_cell_step(campaign_.cases[i].definition.physics);
  };
  EXPECT_NEAR(speed(4), 1000 * campaign_.cases[1].ranks, 1e-6);
  EXPECT_EQ(speed(0), default_ns_per_cell_step(campaign_.cases[0].definition.physics));
}

/// The campaign file may ask for other ranks by now.
TEST_F(Eta, CountsTheRanksThatASpeedWasMeasuredOn) {
  seen_[1].seconds_per_step = 2;
  seen_[1].measured_ranks = 4 * campaign_.cases[1].ranks;
  const Physics& physics = campaign_.cases[1].definition.physics;
  const double on_four = MeasuredSpeed(campaign_, seen_).ns_per_cell_step(physics);
  seen_[1].measured_ranks = 0;
  EXPECT_DOUBLE_EQ(on_four, 4 * MeasuredSpeed(campaign_, seen_).ns_per_cell_step(physics));
  Observation seen;
  seen.end_time = 10;
  seen.time = 4;
  seen.step = 100;
  seen.seconds_per_step = 2;
  seen.measured_ranks = 3 * campaign_.cases[1].ranks;
  EXPECT_DOUBLE_EQ(measured_seconds_left(campaign_.cases[1], seen).value(), 150 * 2.0 * 3);
}

/// It takes as many cores as it works on.
TEST_F(Eta, CountsTheRanksOfARunningSolver) {
  for (std::size_t i = 0; i < 3; ++i) finish(i);
  Status status = report_of_solver();
  status.ranks = 2;
  working_[seen_[3].case_id] = working_[seen_[4].case_id] = status;
  EXPECT_NEAR(left(2), 2 * (50 - 40) / 0.1 * 2, 1e-6);
}

}  // namespace
}  // namespace softwall::campaign
