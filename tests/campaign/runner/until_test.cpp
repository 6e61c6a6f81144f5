#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "campaign/core/plan.hpp"
#include "campaign/core/spec.hpp"
#include "campaign/core/until.hpp"
#include "campaign/observe/run_reports.hpp"
#include "campaign/store/settled.hpp"
#include "tests/campaign/runner/runner_fixture.hpp"

/// Cases that end before their end time, because their intervals are as small as the campaign wants them.
namespace softwall::campaign {
namespace {

/// Its largest departure of the interface is 0.1 on the average, and goes up and down from block to block.
analysis::BlockStatistics waves(int blocks) {
  auto statistics = analysis::samples::elastic_statistics({}, blocks);
  auto& heights = statistics.series["interface_max"];
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = 0.1 + 0.001 * (static_cast<double>(i * 7 % 13) - 6);
  return statistics;
}

using nlohmann::literals::operator""_json_pointer;

constexpr double kEnough = 0.01, kNever = 1e-9;  // half widths of delta_max
constexpr double kStepTime = 0.01;               // h/U_b

class UntilTest : public RunnerTest {
 protected:
  UntilTest() {
    campaign_.cases.resize(2);
    want(kEnough);
  }

  void want(double half_width) {
    campaign_.until = interval_targets({{"delta_max_ci95", half_width}});
    campaign_.cases.back().until = campaign_.until;
  }

  /// A solver that writes four blocks of averages at each checkpoint, a hundred steps apart, and ends when it
  /// is asked to, or at its end time.
  std::optional<int> compute(const LaunchRequest& request, bool asked_to_end) {
    if (request.case_id != id(1)) return finish(request);
    if (request.attempt > 1 && resumed_from_.empty()) resumed_from_ = RunFiles{}.checkpoint(step_).string();
    step_ += 100;
    const double time = kStepTime * static_cast<double>(step_),
                 end = campaign_.cases[1].definition.run.end_time;
    const int blocks = static_cast<int>(step_) / 25;
    write_so_far(request, step_, time, waves(blocks));
    const RunFiles run{request.run_directory};
    if (time >= end) {
      test::write_summary(run, request.case_id, request.attempt, "finished", step_, time, resumed_from_);
      return kDone;
    }
    if (!asked_to_end) return std::nullopt;
    test::write_summary(run, request.case_id, request.attempt, "interrupted", step_, time, resumed_from_);
    return static_cast<int>(ExitCode::kInterrupted);
  }

  RunnerReport run_once() {
    test::WatchedLauncher* asked = nullptr;
    test::WatchedLauncher launcher([&](const LaunchRequest& request) {
      return compute(request, asked != nullptr && !asked->stops.empty());
    });
    asked = &launcher;
    RunnerOptions options;
    options.import_seconds = 0;
    const RunnerReport report = run(launcher, options);
    started_ = launcher.started;
    stops_ = launcher.stops;
    return report;
  }

  [[nodiscard]] std::string of_case(const std::string& column) const {
    Store now = store();
    return tests::answer(now, "SELECT " + column + " FROM cases WHERE case_id = '" + id(1) + "'");
  }

  [[nodiscard]] Decision decision() const {
    const test::FakeLauncher nobody([](const LaunchRequest&) { return kDone; });
    return decide(campaign_, observe_with_records(campaign_, folder_.path(), nobody, store().all_cases()))
        .at(1);
  }

  std::int64_t step_ = 0;
  std::string resumed_from_;
  std::vector<LaunchRequest> started_;
  std::vector<std::pair<Handle, StopLevel>> stops_;
};

TEST(UntilSchema, KnowsTheIntervalsThatThereAre) {
  std::set<std::string> known, there;
  for (const auto& [column, unused] : campaign_schema().part("/until"_json_pointer)->at("properties").items())
    known.insert(column);
  for (const auto& member : analysis::kMeasuredMembers) there.insert(std::string(member.name) + "_ci95");
  EXPECT_EQ(known, there);
}

TEST_F(UntilTest, EndsACaseThatIsPreciseEnough) {
  const RunnerReport report = run_once();
  EXPECT_EQ(report.finished, 2);
  EXPECT_TRUE(report.unfinished.empty());
  ASSERT_EQ(stops_.size(), 1U);
  EXPECT_EQ(stops_[0].second, StopLevel::kCheckpoint);
  EXPECT_GE(step_, 200) << "eight batches of blocks are needed for an interval";
  EXPECT_LT(step_, 1000);
  EXPECT_EQ(of_case("state"), "finished");
  EXPECT_EQ(of_case("state_reason"), "finished early: delta_max within 0.01");
  Store now = store();
  EXPECT_EQ(tests::answer(now, "SELECT outcome FROM attempts WHERE case_id = '" + id(1) + "'"),
            "interrupted");
  EXPECT_EQ(tests::answer(now, "SELECT delta_max_ci95 <= 0.01 FROM results WHERE case_id = '" + id(1) + "'"),
            "1");
  EXPECT_EQ(decision().outlook, Outlook::kKept);
  EXPECT_EQ(decision().reason, "finished early: delta_max within 0.01");
}

TEST_F(UntilTest, KeepsItFromThenOn) {
  run_once();
  const std::int64_t step = step_;
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(run_once().finished, 2);
    EXPECT_TRUE(started_.empty());
  }
  EXPECT_EQ(step_, step);
}

TEST_F(UntilTest, GoesOnFromTheCheckpointForASmallerInterval) {
  run_once();
  const std::int64_t step = step_;
  want(kNever);
  EXPECT_EQ(decision().outlook, Outlook::kResume);
  EXPECT_EQ(run_once().finished, 2) << "at the end time at the latest";
  ASSERT_EQ(started_.size(), 1U);
  EXPECT_TRUE(stops_.empty());
  Store now = store();
  EXPECT_EQ(tests::answer(now, "SELECT resumed_from FROM attempts WHERE attempt = 2"),
            RunFiles{}.checkpoint(step).string());
  EXPECT_EQ(step_, 5000);
  EXPECT_EQ(decision().reason, "finished");
}

TEST_F(UntilTest, GoesOnToTheEndTimeWithoutATarget) {
  run_once();
  campaign_.cases.back().until.clear();
  EXPECT_EQ(decision().outlook, Outlook::kResume);
  run_once();
  EXPECT_EQ(step_, 5000);
}

/// An earlier run stopped it for another reason, or its runner was killed just after the solver had ended.
TEST_F(UntilTest, NeedsNothingOfTheRunnerThatWatchedIt) {
  run_once();
  std::filesystem::remove(store_path(folder_.path()));
  EXPECT_EQ(run_once().finished, 2);
  EXPECT_TRUE(started_.empty());
  EXPECT_EQ(of_case("state_reason"), "finished early: delta_max within 0.01");
}

TEST_F(UntilTest, TellsTheTargetOfNow) {
  run_once();
  want(0.05);
  run_once();
  EXPECT_TRUE(started_.empty());
  EXPECT_EQ(of_case("state_reason"), "finished early: delta_max within 0.05");
}

/// Only an end in order proves that the averages are those of the checkpoint.
TEST_F(UntilTest, DoesNotBelieveAnAttemptThatWasKilled) {
  run_once();
  const RunFiles run{folder_.path() / campaign_.cases[1].directory};
  auto record = read_run_record(run);
  record->attempt += 1;
  write_run_record(run, *record);  // a later attempt that left no summary
  EXPECT_EQ(decision().outlook, Outlook::kResume);
}

TEST_F(UntilTest, GoesOnWhenItsStatisticsAreLost) {
  run_once();
  const std::int64_t step = step_;
  std::filesystem::remove(RunFiles{folder_.path() / campaign_.cases[1].directory}.statistics());
  EXPECT_EQ(decision().outlook, Outlook::kResume);
  EXPECT_EQ(run_once().finished, 2);
  EXPECT_EQ(started_.size(), 1U);
  EXPECT_LT(step_, step + 1000) << "they come back with the next checkpoint";
}

}  // namespace
}  // namespace softwall::campaign
