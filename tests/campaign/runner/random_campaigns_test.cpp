#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "tests/campaign/runner/runner_fixture.hpp"

/// Campaigns whose solvers do anything that a solver may do, in any order. Whatever happens, no case has two
/// attempts at a time, no more cores are used than allowed, every run comes to an end, and a run in which
/// nothing goes wrong any more finishes all that has not diverged.
namespace softwall::campaign {
namespace {

class RandomCampaigns : public RunnerTest, public ::testing::WithParamInterface<unsigned> {
 protected:
  RandomCampaigns() : random_(GetParam()) {
    auto document = tests::elastic_campaign();
    auto& G = document["sweep"]["grid"]["G"];
    G.clear();
    for (int i = 0; i < up_to(3); ++i) G.push_back(1 + i);
    document["execution"] = {{"ranks", up_to(2)}, {"precursor_ranks", up_to(2)}, {"cores", 2 + up_to(3)}};
    cores_ = document["execution"]["cores"];
    campaign_ = tests::campaign_of(document);
  }

  /// A number between 1 and n.
  int up_to(int n) { return std::uniform_int_distribution<int>(1, n)(random_); }

  /// What the solver leaves, and its exit status.
  int play(const LaunchRequest& request) {
    const RunFiles run{request.run_directory};
    const auto& id = request.case_id;
    switch (up_to(9)) {
      case 1:
        return 139;  // crashed
      case 2:
        get_further(run, id);
        return 139;
      case 3:
        get_further(run, id);
        test::write_summary(run, id, request.attempt, "interrupted", steps_[id], 0.01 * steps_[id]);
        return static_cast<int>(ExitCode::kInterrupted);
      case 4:
        if (up_to(3) > 1) return kDone;  // says so, but has left nothing
        test::write_summary(run, id, request.attempt, "diverged", steps_[id], 0.01 * steps_[id]);
        diverged_.insert(id);
        return static_cast<int>(ExitCode::kDiverged);
      case 5:
        return static_cast<int>(ExitCode::kIoFailure);
      default:
        return finish(request);
    }
  }

  void get_further(const RunFiles& run, const std::string& id) {
    test::write_checkpoint(run, id, ++steps_[id], 0.01 * steps_[id]);
  }

  std::mt19937 random_;
  int cores_ = 0;
  std::map<std::string, int> steps_;  ///< safe in a checkpoint
  std::set<std::string> diverged_;
};

/// Refuses a second attempt of a case that is running.
void expect_one_attempt_a_case(const test::FakeLauncher& launcher) {
  std::set<std::string> cases;
  for (const LaunchRequest& one : launcher.running) {
    EXPECT_TRUE(cases.insert(one.case_id).second) << "two attempts at once: " << one.case_id;
  }
}

TEST_P(RandomCampaigns, NeverRunACaseTwiceAtOnceAndComeToAnEnd) {
  for (int again = 0; again < 4; ++again) {
    test::FakeLauncher launcher([&](const LaunchRequest& request) {
      expect_one_attempt_a_case(launcher);
      return play(request);
    });
    const RunnerReport report = run(launcher);
    EXPECT_LE(launcher.most_ranks, cores_);
    EXPECT_EQ(report.finished + report.failed.size() + report.unfinished.size(), campaign_.cases.size());
  }
  test::FakeLauncher launcher([&](const LaunchRequest& request) { return finish(request); });
  const RunnerReport report = run(launcher);
  const bool without_precursor = diverged_.contains(id(0));
  EXPECT_TRUE(report.unfinished.empty());
  for (const CampaignCase& one : campaign_.cases) {
    const bool is_finished = store().find_case(one.definition.id)->state == CaseState::kFinished;
    if (diverged_.contains(one.definition.id)) {
      EXPECT_FALSE(is_finished);
    } else {
      EXPECT_TRUE(is_finished || without_precursor) << one.definition.label;
    }
  }
  for (const LaunchRequest& one : launcher.started) EXPECT_FALSE(diverged_.contains(one.case_id));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCampaigns, ::testing::Range(1U, 21U));

}  // namespace
}  // namespace softwall::campaign
