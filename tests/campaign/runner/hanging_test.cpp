#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>
#include <utility>

#include "campaign/runner/runner.hpp"
#include "tests/campaign/observe/run_directory_files.hpp"
#include "tests/campaign/runner/fake_launcher.hpp"
#include "tests/campaign/runner/runner_fixture.hpp"

/// Attempts that make no step, or do not end when they are asked to.
namespace softwall::campaign {
namespace {

/// An attempt that never makes a step and ends only when it is killed.
class HangingLauncher final : public test::LauncherWithoutMemory {
 public:
  Handle start(const LaunchRequest& request) override {
    running_.push_back(request.case_id);
    return request.case_id;
  }
  std::vector<EndedAttempt> collect() override { return std::exchange(ended_, {}); }
  void stop(const std::filesystem::path&, const Handle& handle, StopLevel level) override {
    asked.push_back(level);
    if (level != StopLevel::kKill || std::erase(running_, handle) == 0) return;
    ended_.push_back({handle, 137});
  }
  [[nodiscard]] bool idle() const override { return running_.empty() && ended_.empty(); }
  std::vector<StopLevel> asked;

 private:
  std::vector<std::string> running_;
  std::vector<EndedAttempt> ended_;
};

/// Whoever writes a checkpoint makes no step; a large case may take long for it.
TEST_F(RunnerTest, AStopThatTakesLongerThanAStepMayIsNoStall) {
  class SlowToStop final : public test::LauncherWithoutMemory {
   public:
    Handle start(const LaunchRequest& request) override {
      raise(SIGTERM);  // taken by the runner's next look at its signals
      running_ = request.case_id;
      return request.case_id;
    }
    std::vector<EndedAttempt> collect() override {
      if (asked_ < 2) return {};  // it has been asked more firmly
      asked_ = 0;
      return {{std::exchange(running_, ""), 128 + SIGTERM}};
    }
    void stop(const std::filesystem::path&, const Handle&, StopLevel) override { ++asked_; }
    /// Until it has been asked to end, nobody takes it for stalled, however slow this machine is.
    [[nodiscard]] std::vector<Presence> presences(const std::vector<AttemptPlace>& places) const override {
      return std::vector<Presence>(places.size(), asked_ > 0 ? Presence::kRunning : Presence::kUnknown);
    }
    [[nodiscard]] bool idle() const override { return running_.empty(); }

   private:
    std::string running_;
    int asked_ = 0;
  } launcher;
  campaign_.cases.resize(1);
  RunnerOptions options;
  options.stall_seconds = 0.005;
  options.grace = {0.1, 0.1};
  const RunnerReport report = run(launcher, options);
  EXPECT_TRUE(report.stopped);
  Store after = store();
  EXPECT_EQ(tests::answer(after, "SELECT outcome || ': ' || reason FROM attempts"),
            "interrupted: stopped on request before it had written a checkpoint");
}

/// The manager's own failure is told before the solvers are waited for, and whoever does not want to wait is
/// heard.
TEST_F(RunnerTest, ARunnerThatFailsSaysWhyAndHearsRequestsToEndSooner) {
  class Failing final : public test::LauncherWithoutMemory {
   public:
    explicit Failing(std::filesystem::path log) : log_(std::move(log)) {}
    Handle start(const LaunchRequest& request) override { return running_ = request.case_id; }
    std::vector<EndedAttempt> collect() override {
      if (!running_.empty() && !std::exchange(has_failed_, true)) throw std::runtime_error("something broke");
      return std::exchange(ended_, {});
    }
    void stop(const std::filesystem::path&, const Handle& handle, StopLevel level) override {
      std::ifstream in(log_);
      said.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
      raise(SIGTERM);
      raise(SIGINT);
      if (level != StopLevel::kKill) return;
      ended_.push_back({handle, 137});
      running_.clear();
    }
    [[nodiscard]] bool idle() const override { return running_.empty() && ended_.empty(); }
    std::vector<std::string> said;

   private:
    std::filesystem::path log_;
    std::string running_;
    bool has_failed_ = false;
    std::vector<EndedAttempt> ended_;
  } launcher(folder_.path() / "manager.log");
  campaign_.cases.resize(1);
  RunnerOptions options;
  options.poll = std::chrono::milliseconds(1);
  Signals signals;
  Progress progress(folder_.path() / "manager.log");
  Store results = Store::open(folder_.path(), OpenMode::kCreate);
  Runner runner(campaign_, folder_.path(), {launcher, results, progress, signals}, options);
  EXPECT_THROW(runner.run(), std::runtime_error);
  ASSERT_EQ(launcher.said.size(), 3U) << "checkpoint, terminate, kill";
  EXPECT_NE(launcher.said.front().find("something broke; waiting for 1 case to write a checkpoint"),
            std::string::npos)
      << launcher.said.front();
}

TEST_F(RunnerTest, AHangingAttemptIsEndedMoreAndMoreFirmlyAndCountedAsStalled) {
  HangingLauncher launcher;
  RunnerOptions options;
  options.stall_seconds = 0.02;
  options.grace = {0.02, 0.02};
  options.poll = std::chrono::milliseconds(1);
  Signals signals;
  Progress progress("");
  Store results = Store::open(folder_.path(), OpenMode::kCreate);
  const auto report =
      Runner(campaign_, folder_.path(), {launcher, results, progress, signals}, options).run();
  EXPECT_EQ(report.failed.size(), 5U);
  EXPECT_EQ(
      tests::answer(results, "SELECT group_concat(outcome) FROM attempts WHERE case_id = '" + id(0) + "'"),
      "stalled,stalled");
  const std::vector<StopLevel> ladder = {StopLevel::kCheckpoint, StopLevel::kTerminate, StopLevel::kKill};
  EXPECT_EQ(std::vector(launcher.asked.begin(), launcher.asked.begin() + 3), ladder);
}

}  // namespace
}  // namespace softwall::campaign
