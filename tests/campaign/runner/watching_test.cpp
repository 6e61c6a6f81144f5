#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <utility>

#include "solver/run_directory/exit_codes.hpp"
#include "solver/run_directory/statistics_file.hpp"
#include "solver/run_directory/status.hpp"
#include "tests/campaign/runner/runner_fixture.hpp"

/// What the runner does about attempts while they are at work.
namespace softwall::campaign {
namespace {

/// A case that writes checkpoints and is then stopped: its averages are in the store before it ends, with
/// their window and its state.
TEST_F(RunnerTest, RecordsTheAveragesSoFarAtEveryCheckpoint) {
  const std::string watched = id(1);
  std::vector<std::string> states, windows;
  int asked = 0;
  test::WatchedLauncher launcher([&](const LaunchRequest& request) -> std::optional<int> {
    if (request.case_id != watched) return finish(request);
    if (asked > 0) {
      Store now = store();
      states.push_back(tests::answer(now, "SELECT state FROM results WHERE case_id = '" + watched + "'"));
      windows.push_back(
          tests::answer(now, "SELECT window_end FROM results WHERE case_id = '" + watched + "'"));
    }
    if (request.attempt > 1) return finish(request);
    ++asked;
    write_so_far(request, 100 * asked, asked, analysis::samples::elastic_statistics({}, 10 * asked));
    if (asked < 3) return std::nullopt;
    test::write_summary(RunFiles{request.run_directory}, watched, request.attempt, "interrupted", 300, 3.0);
    return static_cast<int>(ExitCode::kInterrupted);
  });
  RunnerOptions options;
  options.import_seconds = 0;
  campaign_.cases.resize(2);
  run(launcher, options);
  // Ten more blocks of length 2 at each checkpoint, from t = 100; the last answer is that of the next
  // attempt.
  EXPECT_EQ(windows, (std::vector<std::string>{"120.0", "140.0", "160.0"}));
  EXPECT_EQ(states.front(), "running");
}

/// Ranks that hang in MPI_Init never report and never hold the lock: they are ended long before the time that
/// a step may take, and at once firmly, because they can write no checkpoint.
TEST_F(RunnerTest, EndsRanksThatDoNotGetThroughMpiInit) {
  class Launcher final : public test::LauncherWithoutMemory {
   public:
    Handle start(const LaunchRequest& request) override {
      running = request;
      ++started;
      return "it";
    }
    std::vector<EndedAttempt> collect() override {
      if (!running || levels.empty()) return {};
      levels.clear();
      return {{std::exchange(running, std::nullopt)->case_id, 128 + SIGTERM}};
    }
    [[nodiscard]] std::vector<Presence> presences(const std::vector<AttemptPlace>& places) const override {
      return std::vector<Presence>(places.size(), running ? Presence::kRunning : Presence::kGone);
    }
    void stop(const std::filesystem::path&, const Handle&, StopLevel level) override {
      levels.push_back(level);
      asked.push_back(level);
    }
    [[nodiscard]] bool idle() const override { return !running; }
    std::optional<LaunchRequest> running;
    std::vector<StopLevel> levels, asked;
    int started = 0;
  } launcher;
  campaign_.cases.resize(1);
  RunnerOptions options;
  options.begin_seconds = 0.02;
  const RunnerReport report = run(launcher, options);
  EXPECT_EQ(launcher.started, 2);  // no progress twice: given up
  ASSERT_EQ(report.failed.size(), 1U);
  EXPECT_EQ(launcher.asked.front(), StopLevel::kTerminate);
  Store after = store();
  EXPECT_EQ(tests::answer(after, "SELECT outcome || ': ' || reason FROM attempts"),
            "stalled: its ranks did not get through MPI_Init in 0 s");
}

}  // namespace
}  // namespace softwall::campaign
